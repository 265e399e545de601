/*
 * A sink for the JSON text of a glTF, which sorts it into spools by member: so
 * the arrays that grow with the city are written batch by batch, and stand one
 * after the other in the end. For gltf_assembly only; C++.
 */
#ifndef TESSERA_GLTF_SPLITTER_H
#define TESSERA_GLTF_SPLITTER_H

#include <streambuf>
#include <string>

extern "C" {
#include "fault.h"
#include "gltf_spool.h"
}

/* Top-level members that grow with the city; the others are `rest`. */
enum member { ACCESSORS, MESHES, NODES, REST, MEMBERS };

inline const char *const member_names[] = {"accessors", "meshes", "nodes"};

/*
 * A sink for the JSON text that tinygltf writes: the elements of the arrays
 * that grow go to their spools, and the other members, where wanted, to the
 * spool of the rest. The text is compact, without white space.
 */
class splitter : public std::streambuf
{
      public:
	splitter(struct spool *members, bool keep_rest)
	    : spools(members), keeps_rest(keep_rest)
	{
	}

	enum tcs_status status = TCS_OK;
	struct tcs_fault fault = {};

      protected:
	std::streamsize xsputn(
		const char *text, std::streamsize count) override;
	int_type overflow(int_type c) override;

      private:
	void put(const char *bytes, std::size_t size);
	void flush(const char *end);
	void begin_value(const char *next);
	void end_value(const char *at);
	void take_string(const char *at);
	void take(const char *at);

	struct spool *spools;
	bool keeps_rest;
	int depth = 0;
	bool in_string = false, escaped = false, in_value = false;
	bool inner = false; /* of an array whose brackets are dropped */
	std::string key;
	struct spool *to = nullptr; /* of the value; null: dropped */
	const char *run = nullptr; /* bytes not yet put begin here */
};

#endif
