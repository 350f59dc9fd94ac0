# Sourced by jobs/test-*, which set $me, $root and $work, an empty folder; $disk is where the job lies.  POSIX sh.
# Renders a film alone and by a job, and compares.
# shellcheck shell=sh disable=SC2154

bad=0
fault() {
    say "$@"
    bad=$((bad + 1))
}

# make_program: writes $work/program, which is the program as the tasks call it: it notes which process it is, and how that ends.  Where no disk
# can be filled, a limit to the size of files stands for one that is full.
make_program() {
    real=${SIMPLERAY:-$root/simpleray}
    mkdir -p "$work/running"
    : >"$work/runs"
    : >"$work/seen"
    cat >"$work/program" <<END
#!/bin/sh
(
    [ ! -e "$work/full" ] || ulimit -f 0
    exec "$real" "\$@"
) &
echo "\$!" >"$work/running/\$!"
wait "\$!"
status=\$?
rm -f "$work/running/\$!"
echo "\$status \$*" >>"$work/runs"
exit "\$status"
END
    chmod +x "$work/program"
}

# running WHICH: prints the number of a process of the program that runs, as sed's address says
running() { find "$work/running" -type f | sort | sed -n "$1s:.*/::p"; }

# render_alone [SCENE]...: the pictures and the film as one process makes them, in $work/alone
render_alone() {
    started=$(date +%s)
    # shellcheck disable=SC2086  # two words
    "$real" job "${1:-$film}" $frames --for openjd --chunk 1000000 -o "$work/alone" || exit
    { SIMPLERAY=$real sh "$work/alone/job.sh" task 0 && SIMPLERAY=$real sh "$work/alone/job.sh" finish; } ||
        { say 'one machine alone cannot render it'; exit 1; }
    say "one process: $(($(date +%s) - started)) s"
}
film=$root/jobs/film.scene
frames=                                              # or an option of simpleray job

# make_job [SCENE [BANDS [CHUNK]]] OPTION...: the job, in $disk/job
make_job() {
    scene=$film bands=3 chunk=2
    case ${1-} in --*) ;; ?*) scene=$1; shift ;; esac
    case ${1-} in --*) ;; ?*) bands=$1; shift ;; esac
    case ${1-} in --*) ;; ?*) chunk=$1; shift ;; esac
    # shellcheck disable=SC2086  # two words
    "$real" job "$scene" $frames --bands "$bands" --chunk "$chunk" -o "$disk/job" "$@" || exit
}

# look: notes each picture that is there, with what changes if it is made again
look() {
    for picture in "$disk"/job/parts/*.png "$disk"/job/frames/*.png "$disk"/job/*.png; do
        [ ! -e "$picture" ] || stat -c '%n %i %y' "$picture" 2>/dev/null >>"$work/seen"
    done
}

# compare: ends well if the job has made all that one process makes, byte for byte, and nothing twice
compare() {
    for file in $(cd "$work/alone" && find . -name '*.png' -o -name 'film.*'); do
        cmp "$work/alone/$file" "$disk/job/$file" >&2 || fault "$file is not as it ought to be"
    done
    twice=$(sort -u "$work/seen" | cut -d ' ' -f 1 | uniq -d)
    [ -z "$twice" ] || fault 'made twice, though it was whole:' "$twice"
    left=$(cd "$disk/job" && find . -name '*.part')
    [ -z "$left" ] || fault 'left behind:' "$left"
    [ "$bad" -eq 0 ] || exit 1
    say "all $(cd "$work/alone" && find . -name '*.png' | wc -l) pictures are as one process makes them, and none was made twice"
}
