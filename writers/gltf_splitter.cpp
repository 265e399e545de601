#include "gltf_splitter.h"

std::streamsize
splitter::xsputn(const char *text, std::streamsize count)
{
	run = in_value && (!inner || depth > 1) ? text : nullptr;
	for (const char *at = text; at < text + count; at++)
		take(at);
	if (run)
		flush(text + count);
	return status ? 0 : count;
}

splitter::int_type
splitter::overflow(int_type c)
{
	char text = traits_type::to_char_type(c);

	return xsputn(&text, 1) == 1 ? c : traits_type::eof();
}

void
splitter::put(const char *bytes, std::size_t size)
{
	if (to && !status && size)
		status = spool_write(to, bytes, size, &fault);
}

void
splitter::flush(const char *end)
{
	if (run && end > run)
		put(run, static_cast<std::size_t>(end - run));
	run = nullptr;
}

void
splitter::begin_value(const char *next)
{
	in_value = true;
	inner = false;
	to = keeps_rest ? spools + REST : nullptr;
	for (int i = 0; i < REST; i++)
		if (key == member_names[i]) {
			to = spools + i;
			inner = true;
		}
	if (to && to->size)
		put(",", 1);
	if (!inner) {
		key = '"' + key + "\":";
		put(key.data(), key.size());
	}
	run = inner ? nullptr : next;
}

void
splitter::end_value(const char *at)
{
	if (in_value)
		flush(at);
	in_value = false;
	key.clear();
}

void
splitter::take_string(const char *at)
{
	if (escaped)
		escaped = false;
	else if (*at == '\\')
		escaped = true;
	else if (*at == '"')
		in_string = false;
	if (in_string && !in_value && depth == 1)
		key += *at;
}

void
splitter::take(const char *at)
{
	if (in_string) {
		take_string(at);
		return;
	}
	switch (*at) {
	case '"':
		in_string = true;
		break;
	case '{':
	case '[':
		depth++;
		if (depth == 2 && inner)
			run = at + 1;
		break;
	case '}':
	case ']':
		depth--;
		if (depth == 0 || (depth == 1 && inner))
			end_value(at);
		break;
	case ':':
		if (depth == 1)
			begin_value(at + 1);
		break;
	case ',':
		if (depth == 1)
			end_value(at);
		break;
	default:
		break;
	}
}
