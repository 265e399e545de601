/*
 * tinygltf alone: load a GLB, then write it again as a GLB. Prints the CPU
 * time of the writing, the loading left out.
 *
 *     gltf_bare IN.glb OUT.glb
 */
#include <cstdio>
#include <ctime>
#include <string>

#include <tiny_gltf.h>

static double
cpu_seconds()
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return static_cast<double>(now.tv_sec) +
		1e-9 * static_cast<double>(now.tv_nsec);
}

int
main(int argc, char **argv)
{
	tinygltf::TinyGLTF tiny;
	tinygltf::Model model;
	std::string error, warning;

	if (argc != 3 ||
		!tiny.LoadBinaryFromFile(&model, &error, &warning, argv[1])) {
		std::fprintf(stderr, "gltf_bare: %s\n", error.c_str());
		return 1;
	}
	double before = cpu_seconds();
	bool done = tiny.WriteGltfSceneToFile(
		&model, argv[2], true, true, false, true);

	std::printf("bare tinygltf: %.2f s CPU to write the same\n",
		cpu_seconds() - before);
	return done ? 0 : 1;
}
