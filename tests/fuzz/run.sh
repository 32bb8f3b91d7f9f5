#!/bin/sh
# run.sh TARGET FOLDER OPTIONS ..: runs a fuzzer on its corpus in FOLDER/TARGET and says how many executions
# there were, and how many a second. What it reports stays in FOLDER; the end of its log is shown.
set -u
target=$1 folder=$2
shift 2
log=$folder/$target.log
if ! "$folder/fuzz/fuzz-$target" "$@" -timeout=20 -rss_limit_mb=2000 -print_final_stats=1 \
    -artifact_prefix="$folder/$target-" "$folder/$target" >"$log" 2>&1; then
    tail -n 60 "$log"
    echo "FAIL fuzz-$target: $log; to see it again: $folder/fuzz/fuzz-$target FILE"
    exit 1
fi
awk -v target="$target" '/number_of_executed_units/ { n = $2 } /average_exec_per_sec/ { s = $2 }
    END { printf "%s: %d executions without a report, %d a second\n", target, n, s }' "$log"
