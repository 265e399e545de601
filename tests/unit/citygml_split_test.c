#include "parsers/citygml_split.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"

static char name[] = "/tmp/tessera-split-XXXXXX";

/* The pieces of a document, members in brackets; lines and places agree. */
static void
split(const char *document, uint64_t max_member, size_t most_members, char *out,
	size_t room)
{
	FILE *file = fopen(name, "wb");
	struct splitter splitter = {.max_member = max_member};
	struct document_bytes bytes = {0};
	struct document_pieces pieces = {0};
	uint64_t at = 0, line = 1;
	struct tcs_fault fault;
	struct input input;

	CHECK(file && fputs(document, file) >= 0);
	fclose(file);
	CHECK(!input_open(&input, name, &fault));
	splitter.input = &input;
	*out = 0;
	do {
		CHECK(!split_next(
			&splitter, most_members, &bytes, &pieces, &fault));
		for (size_t i = 0; i < pieces.count; i++) {
			const struct document_piece *piece = &pieces.at[i];

			CHECK(piece->at == at && piece->line == line);
			snprintf(out + strlen(out), room - strlen(out),
				piece->is_member ? "[%.*s]" : "%.*s",
				(int)piece->length, bytes.at + piece->first);
			for (size_t k = 0; k < piece->length; k++)
				line += document[at + k] == '\n';
			at += piece->length;
		}
	} while (pieces.count);
	CHECK(at == strlen(document));
	splitter_release(&splitter);
	array_release(&bytes);
	array_release(&pieces);
	input_close(&input);
}

static bool
splits(const char *document, uint64_t max_member, const char *expected)
{
	char one[1000], all[1000];

	split(document, max_member, 1, one, sizeof one);
	split(document, max_member, SIZE_MAX, all, sizeof all);
	if (strcmp(all, expected) != 0)
		fprintf(stderr, "%s\n", all);
	return !strcmp(one, expected) && !strcmp(all, expected);
}

static void
members_stand_by_themselves(void)
{
	CHECK(splits("<M>\n <c:cityObjectMember><b/>\n</c:cityObjectMember>\n"
		     "<featureMember a=''>x</featureMember ></M>\n",
		1000,
		"<M>\n [<c:cityObjectMember><b/>\n</c:cityObjectMember>]\n"
		"[<featureMember a=''>x</featureMember >]</M>\n"));
}

static void
all_else_is_other(void)
{
	CHECK(splits("", 1000, ""));
	CHECK(splits("no markup", 1000, "no markup"));
	CHECK(splits("<M><cityObjectMembers/><cityObjectMember", 1000,
		"<M><cityObjectMembers/><cityObjectMember"));
	CHECK(splits("<M><a:cityObjectMember></b:cityObjectMember>", 1000,
		"<M><a:cityObjectMember></b:cityObjectMember>"));
	CHECK(splits("<M> <cityObjectMember>1234</cityObjectMember>"
		     "<cityObjectMember></cityObjectMember>",
		38,
		"<M> <cityObjectMember>1234</cityObjectMember>"
		"[<cityObjectMember></cityObjectMember>]"));
}

/* Longer than what is read at once, cut anywhere. */
static void
reading_makes_no_difference(void)
{
	static char document[400000], out[500000];
	size_t length = 0, members = 0, found = 0;

	while (length < sizeof document - 10000) {
		length += (size_t)sprintf(document + length,
			"<!-- %*s --><m:cityObjectMember>%*s"
			"</m:cityObjectMember>\n",
			(int)(members % 71), "", (int)(members % 9 * 1000), "");
		members++;
	}
	split(document, UINT64_MAX, 7, out, sizeof out);
	for (const char *at = out; *at; at++)
		found += *at == '[';
	CHECK(found == members);
}

static const struct check_test tests[] = {
	CHECK_TEST(members_stand_by_themselves),
	CHECK_TEST(all_else_is_other),
	CHECK_TEST(reading_makes_no_difference),
	{0},
};

int
main(void)
{
	int result;

	close(mkstemp(name));
	result = check_run(tests);
	unlink(name);
	return result;
}
