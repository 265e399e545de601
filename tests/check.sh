# shellcheck shell=bash
# The few lines a test script needs; it sources this file and ends in
# `finish`. A test is a function named as a sentence; `run_test NAME` runs it
# in an empty folder of its own and takes its status: `set -e` is on in it.
set -u

tests_passed=0
tests_failed=0
tests_skipped=0
tests_folder=$(mktemp -d) || exit 1
trap 'chmod -R u+w "$tests_folder"; rm -rf "$tests_folder"' EXIT

# run_test NAME [ARGUMENT...]
run_test() {
	mkdir "$tests_folder/$1" || exit 1
	(
		cd "$tests_folder/$1" || exit 1
		set -e
		"$@"
	) >"$tests_folder/log" 2>&1 </dev/null
	local status=$?
	if ((status == 0)); then
		tests_passed=$((tests_passed + 1))
	else
		tests_failed=$((tests_failed + 1))
		echo "failed: $*" >&2
		sed 's/^/    /' "$tests_folder/log" >&2
	fi
	chmod -R u+w "$tests_folder/$1"
	rm -rf "${tests_folder:?}/$1"
}

# skip NAME REASON
skip() {
	tests_skipped=$((tests_skipped + 1))
	echo "skipped: $1: $2"
}

# is ACTUAL EXPECTED: fail, saying how, when the two words differ.
is() {
	[[ $1 == "$2" ]] && return
	echo "not so: '$1' is '$2'"
	return 1
}

# silent COMMAND...: fail when the command prints anything, and show it.
silent() {
	local said
	said=$("$@" 2>&1) || :
	[[ ! $said ]] && return
	echo "$said"
	return 1
}

# status_is N COMMAND...: fail when the command ends otherwise.
status_is() {
	local want=$1 got=0
	shift
	"$@" || got=$?
	is "$got" "$want" || {
		echo "of: $*"
		return 1
	}
}

finish() {
	printf '%d passed, %d failed' $tests_passed $tests_failed
	((tests_skipped)) && printf ', %d skipped' $tests_skipped
	printf '\n'
	((tests_failed == 0))
	exit
}

# Whether the programs are built with sanitizers: "yes", or nothing.
sanitized=
if grep -qse -fsanitize "${BUILD:-}/flags"; then
	sanitized=yes
fi

# bounded MEGABYTES COMMAND...: in so much memory, and a minute. The limit is on
# addresses, of which libraries and threads reserve 256 MB. A sanitized build
# reserves far more, and is not bounded.
bounded() {
	local megabytes=$1
	shift
	(
		[[ $sanitized ]] || ulimit -v $(((megabytes + 256) * 1024))
		exec timeout 60 "$@"
	)
}
