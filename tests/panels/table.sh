#!/bin/sh
# The table of panels in ports/README.md, between <!-- panels --> and <!-- /panels -->.
#       table.sh check|update BUILD
# The last line is "N passed, N failed".
build=$2
page=ports/README.md
# shellcheck disable=SC2086
${RUN:-} "$build/panel-table" >"$build/panel-table.md" || {
    echo "0 passed, 1 failed"
    exit 1
}
awk -v table="$build/panel-table.md" '
    /^<!-- \/panels -->/ { inside = 0 }
    !inside { print }
    /^<!-- panels -->/ { inside = 1; while ((getline line <table) > 0) print line }
' "$page" >"$build/panels-page.md"
if [ "$1" = update ]; then
    cp "$build/panels-page.md" "$page"
elif ! cmp -s "$page" "$build/panels-page.md"; then
    echo "FAIL the table in $page is not what is sent; see make panels-update"
    diff "$page" "$build/panels-page.md"
    echo "0 passed, 1 failed"
    exit 1
fi
echo "$(grep -c '^| `' "$build/panel-table.md") panels: the table is what is sent"
echo "1 passed, 0 failed"
