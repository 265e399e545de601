#!/bin/sh
# tests/packages.sh PURPOSE...: see that the Debian packages listed in
# tests/packages/PURPOSE.txt are there; name and install those that are not.
set -eu

lists=$(dirname "$0")/packages
missing=

is_there() {
	case $1 in
	*:*) command -v "${1#*:}" >/dev/null 2>&1 && return ;;
	esac
	# shellcheck disable=SC2016 # the ${} is dpkg-query's
	state=$(dpkg-query -W -f='${db:Status-Status}' "${1%%:*}" 2>/dev/null) ||
		return 1
	[ "$state" = installed ]
}

has_lists() {
	set -- /var/lib/apt/lists/*_Packages*
	[ -e "$1" ]
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
	echo "No Debian system: see $lists for what has to be installed." >&2
	exit 0
fi

for purpose; do
	while read -r package rest; do
		case $package in
		'' | '#'*) continue ;;
		esac
		is_there "$package" || missing="$missing ${package%%:*}"
	done <"$lists/$purpose.txt"
done
[ -n "$missing" ] || exit 0

echo "Missing Debian packages:$missing"
if [ "$(id -u)" = 0 ]; then
	as_root=
elif command -v sudo >/dev/null; then
	as_root=sudo
else
	echo "Neither root nor sudo; as root: apt-get install$missing" >&2
	exit 1
fi

export DEBIAN_FRONTEND=noninteractive
has_lists || $as_root apt-get update
# shellcheck disable=SC2086 # words on purpose
install() {
	$as_root env DEBIAN_FRONTEND=noninteractive \
		apt-get install -y -q --no-install-recommends $missing </dev/null
}
# Lists that have aged name files that are gone: fetch them anew, once.
install || {
	$as_root apt-get update
	install
}
