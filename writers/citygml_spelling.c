/* Values of attributes as the schema spells them. */
#include <stdlib.h>
#include <string.h>

#include "citygml_compose.h"
#include "number.h"

static bool
is_digits(const char *at, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (at[i] < '0' || at[i] > '9')
			return false;
	return true;
}

/* What may follow a date or a time: a time zone. */
static bool
is_zone(const char *at)
{
	if (!*at || !strcmp(at, "Z"))
		return true;
	return (*at == '+' || *at == '-') && strlen(at) == 6 &&
		is_digits(at + 1, 2) && at[3] == ':' && is_digits(at + 4, 2);
}

/* "2024-06-01", a day that exists. */
static bool
begins_with_date(const char *at)
{
	static const char days[] = {
		31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
	int year, month, day;

	if (strlen(at) < 10 || !is_digits(at, 4) || at[4] != '-' ||
		!is_digits(at + 5, 2) || at[7] != '-' || !is_digits(at + 8, 2))
		return false;
	year = atoi(at);
	month = atoi(at + 5);
	day = atoi(at + 8);
	if (year < 1 || month < 1 || month > 12 || day < 1 ||
		day > days[month - 1])
		return false;
	return month != 2 || day < 29 ||
		(year % 4 == 0 && (year % 100 != 0 || year % 400 == 0));
}

static bool
is_year(const char *at)
{
	at += *at == '-';
	return strlen(at) >= 4 && is_digits(at, 4) && strncmp(at, "0000", 4) &&
		is_zone(at + 4);
}

static bool
is_time(const char *at)
{
	size_t fraction = 0;

	if (!begins_with_date(at) || at[10] != 'T' || strlen(at) < 19 ||
		!is_digits(at + 11, 2) || at[13] != ':' ||
		!is_digits(at + 14, 2) || at[16] != ':' ||
		!is_digits(at + 17, 2))
		return false;
	at += 19;
	if (*at == '.') {
		while (at[1 + fraction] >= '0' && at[1 + fraction] <= '9')
			fraction++;
		at += 1 + fraction;
		if (!fraction)
			return false;
	}
	return is_zone(at);
}

static bool
is_integer(const char *at)
{
	at += *at == '-' || *at == '+';
	return *at && is_digits(at, strlen(at));
}

static bool
is_number(const char *at)
{
	const char *end = at + strlen(at);
	double number;

	at += *at == '+';
	return *at && number_parse(at, end, &number) == end;
}

static bool
are_numbers(const char *at)
{
	const char *end = at + strlen(at);
	size_t count = 0;
	double number;

	for (at += strspn(at, " \t\r\n"); at < end; count++) {
		at = number_parse(at, end, &number);
		if (!at || !strchr(" \t\r\n", *at))
			return false;
		at += strspn(at, " \t\r\n");
	}
	return count > 0;
}

static bool
is_one_of(const char *word, const char *words)
{
	size_t length = strlen(word);

	while (length && *words) {
		size_t part = strcspn(words, " ");

		if (part == length && !memcmp(words, word, length))
			return true;
		words += part + (words[part] == ' ');
	}
	return false;
}

static const char *
words_of(unsigned content)
{
	switch (content) {
	case CONTENT_BOOLEAN:
		return "true false 1 0";
	case CONTENT_TERRAIN:
		return "entirelyAboveTerrain substantiallyAboveTerrain "
		       "substantiallyAboveAndBelowTerrain "
		       "substantiallyBelowTerrain entirelyBelowTerrain";
	case CONTENT_WATER:
		return "entirelyAboveWaterSurface "
		       "substantiallyAboveWaterSurface "
		       "substantiallyAboveAndBelowWaterSurface "
		       "substantiallyBelowWaterSurface "
		       "entirelyBelowWaterSurface "
		       "temporarilyAboveAndBelowWaterSurface";
	case CONTENT_SPACETYPE:
		return "closed open semiOpen";
	case CONTENT_CONDITION:
		return "declined demolished functional projected ruin "
		       "underConstruction";
	case CONTENT_RELATION:
		return "inside outside bothInsideAndOutside";
	case CONTENT_GRANULARITY:
		return "lane way";
	case CONTENT_DIRECTION:
		return "forwards backwards both";
	default:
		return "";
	}
}

static const char *
joined(struct composer *composer, const char *first, size_t length,
	const char *second)
{
	char *text = arena_get(&composer->arena, length + strlen(second) + 1);

	if (!text) {
		composer->out->markup.failed = true;
		return NULL;
	}
	memcpy(text, first, length);
	strcpy(text + length, second);
	return text;
}

/* A date as another kind of date; NULL where that cannot be. */
static const char *
date_as(struct composer *composer, unsigned content, const char *value)
{
	bool date = begins_with_date(value);

	switch (content) {
	case CONTENT_DATE:
		if (date && is_zone(value + 10))
			return value;
		if (is_time(value))
			return joined(composer, value, 10, "");
		return is_year(value) && *value != '-'
			? joined(composer, value, 4, "-01-01")
			: NULL;
	case CONTENT_TIME:
		if (is_time(value))
			return value;
		return date && is_zone(value + 10)
			? joined(composer, value, 10, "T00:00:00")
			: NULL;
	default:
		if (is_year(value))
			return value;
		return date ? joined(composer, value, 4, "") : NULL;
	}
}

static const char *
level_as(const struct composer *composer, const char *value)
{
	if (strlen(value) != 1 || *value < '0' || *value > '4')
		return NULL;
	return *value == '4' && compose_is_3(composer) ? "3" : value;
}

const char *
value_as(struct composer *composer, const struct tcs_attribute *attribute,
	unsigned content)
{
	const char *value = compose_text(composer, attribute->value);
	bool has_unit = *compose_text(composer, attribute->unit) != '\0';

	switch (content) {
	case CONTENT_STRING:
	case CONTENT_CODE:
	case CONTENT_URI:
		return has_unit ? NULL : value;
	case CONTENT_DATE:
	case CONTENT_TIME:
	case CONTENT_YEAR:
		return date_as(composer, content, value);
	case CONTENT_INTEGER:
		return is_integer(value) ? value : NULL;
	case CONTENT_COUNT:
		return is_integer(value) && *value != '-' ? value : NULL;
	case CONTENT_DOUBLE:
		return is_number(value) ? value : NULL;
	case CONTENT_MEASURE:
		return is_number(value) && has_unit ? value : NULL;
	case CONTENT_MEASURES:
		return are_numbers(value) && has_unit ? value : NULL;
	case CONTENT_LEVEL:
		return level_as(composer, value);
	default:
		return is_one_of(value, words_of(content)) ? value : NULL;
	}
}

bool
value_is_shortened(const struct composer *composer,
	const struct tcs_attribute *attribute, unsigned content)
{
	const char *value = compose_text(composer, attribute->value);
	const char *rest;

	if (content == CONTENT_YEAR && begins_with_date(value))
		rest = "-01-01";
	else if (content == CONTENT_DATE && is_time(value))
		rest = "T00:00:00";
	else
		return false;
	return strcmp(value + (*rest == 'T' ? 10 : 4), rest) != 0;
}
