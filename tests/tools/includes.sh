#!/bin/sh
# The include rules of core, hal and the ports that are part of the library, and no float in them.
#       includes.sh [DIRECTORY]         the tree to look at, default .
#   core and hal   of the system headers only stdint, stddef, stdbool, limits
#   core/base      nothing but itself
#   core/vertex, core/raster, core/fragment    themselves and core/base
#   core/*         nothing outside core
#   hal            itself and core/base
#   ports/spi_lcd, ports/framebuffer    themselves, hal and core/base
# The last line is "N passed, N failed", one a file.
cd "${1:-.}" || exit 1
passed=0 failed=0

# $1 file, $2 name in quotes: the path from the root, without dots
resolve()
{
    echo "${1%/*}/$2" | awk -F/ '{
        n = 0
        for (i = 1; i <= NF; i++)
            if ($i == "..") n--
            else if ($i != ".") part[++n] = $i
        for (i = 1; i <= n; i++) printf "%s%s", part[i], i < n ? "/" : "\n"
    }'
}

# $1 file, $2 included path: is it allowed?
allowed()
{
    case $1 in
    core/base/*) case $2 in core/base/*) return 0 ;; esac ;;
    core/vertex/* | core/raster/* | core/fragment/*)
        folder=${1#core/}
        folder=core/${folder%%/*}
        case $2 in core/base/* | "$folder"/*) return 0 ;; esac ;;
    core/*) case $2 in core/*) return 0 ;; esac ;;
    hal/*) case $2 in hal/* | core/base/*) return 0 ;; esac ;;
    ports/*) case $2 in "${1%/*}"/* | hal/* | core/base/*) return 0 ;; esac ;;
    esac
    return 1
}

# The code of a file without comments and strings.
code()
{
    ${CC:-gcc} -fpreprocessed -dD -E -P "$1" 2>/dev/null | sed 's/"[^"]*"//g'
}

check_file()
{
    bad=
    for name in $(sed -n 's/^ *# *include *<\([^>]*\)>.*/\1/p' "$1"); do
        case $name in
        stdint.h | stddef.h | stdbool.h | limits.h) ;;
        *) echo "FAIL $1: includes <$name>" && bad=1 ;;
        esac
    done
    for name in $(sed -n 's/^ *# *include *"\([^"]*\)".*/\1/p' "$1"); do
        path=$(resolve "$1" "$name")
        [ -f "$path" ] || { echo "FAIL $1: no such file $path" && bad=1; }
        allowed "$1" "$path" || { echo "FAIL $1: must not include $path" && bad=1; }
    done
    if code "$1" | grep -Eqw 'float|double|__fp16|_Float[0-9a-z]*'; then
        echo "FAIL $1: floating point" && bad=1
    fi
    [ -z "$bad" ]
}

for file in $(find core hal ports/spi_lcd ports/framebuffer -name '*.[ch]' | sort); do
    if check_file "$file"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done
echo "includes of $((passed + failed)) files of core, hal and ports, no float in them"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
