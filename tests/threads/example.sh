#!/bin/sh
# example.sh BUILD CC FLAGS: the program of ports/TASKS.md as it stands there, compiled and run.
set -eu
build=$1 cc=$2 flags=$3
mkdir -p "$build/threads"
sed -n '/^<!-- example -->$/,/^<!-- \/example -->$/p' ports/TASKS.md | sed '/^```/d; /^<!--/d' \
    >"$build/threads/example.c"
# $flags is a list of words
$cc -std=c11 -Wall -Wextra -Wpedantic -Werror -O1 -g $flags -I. "$build/threads/example.c" \
    ports/pthread/pthread_monitor.c "$build/libetch.a" -lpthread -o "$build/threads/example"
"$build/threads/example"
echo "ports/TASKS.md: its program draws"
