#!/bin/sh
# rounding.sh BUILD: each tests/prove/NAME.gappa through gappa. A line "# take A B: FILE: SED" takes constants out
# of a source, so that what is proved is about the source as it stands.
build=$1
passed=0 failed=0
command -v gappa >/dev/null || { echo "make prove needs gappa: make deps installs it"; exit 1; }
mkdir -p "$build"
for file in ${PROVE:-tests/prove/*.gappa}; do
    name=$(basename "$file" .gappa)
    cp "$file" "$build/$name.g"
    sed -n 's/^# take //p' "$file" >"$build/$name.take"
    while IFS= read -r take; do
        names=${take%%:*} rest=${take#*: }
        source=${rest%%: *} script=${rest#*: }
        # shellcheck disable=SC2086
        set -- $(sed -n "$script" "$source")
        [ $# -eq "$(echo "$names" | wc -w)" ] || echo "$name: $source has not $names once" >>"$build/$name.g"
        for letter in $names; do
            sed "s/{$letter}/${1:-?}/g" "$build/$name.g" >"$build/$name.new" && mv "$build/$name.new" "$build/$name.g"
            [ $# -eq 0 ] || shift
        done
    done <"$build/$name.take"
    # A rewriting rule that gappa cannot check is an assumption: it warns, here that is a failure.
    if gappa "$build/$name.g" >"$build/$name.log" 2>&1 &&
        ! grep -q "not trivially equal" "$build/$name.log"; then
        echo "$name: proved by gappa"
        passed=$((passed + 1))
    else
        cat "$build/$name.log"
        echo "$name: not proved by gappa"
        failed=$((failed + 1))
    fi
    sed -n 's/^# proved: /    proved: /p; s/^#         /            /p' "$file"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
