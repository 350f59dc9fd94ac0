#!/bin/sh
# The pieces of one job, for any engine and by hand:
#     sh job.sh render FRAMES [BAND]    renders pictures, or one band of each; FRAMES such as 0-9,20
#     sh job.sh task K                  renders piece K of the job, counted from 0
#     sh job.sh merge [FRAMES]          makes pictures of their bands
#     sh job.sh film                    makes the film of all pictures
#     sh job.sh finish                  all that is left to do when all pieces are rendered: merge and film
# $SIMPLERAY is the program; without it, simpleray is looked for on the PATH. What is there and whole is not made again, and what is missing
# is named. Exit codes are the program's; 66 if something is missing.
# shellcheck disable=SC2015,SC3013  # -nt, which all shells know and POSIX since 2024

#@job@

say() { printf 'job.sh: %s\n' "$*" >&2; }

case $0 in */*) cd -- "${0%/*}/" || exit 66 ;; esac
[ -f "$scene" ] || { say "there is no $scene here: run it in the job's folder, where it lies"; exit 66; }

threads=${SLURM_CPUS_PER_TASK-}
memory=${SLURM_MEM_PER_NODE-}                        # in MiB; Java itself needs some of it
[ -z "$memory" ] || [ "$memory" -le 0 ] || export SIMPLERAY_OPTS="-Xmx$((memory > 2 * java ? memory - java : memory / 2))m ${SIMPLERAY_OPTS-}"
progress=-q
[ "${1-}" != openjd ] || { progress='--progress openjd'; shift; }

# render_by COMMAND ARG...: the program with all that the job says of its pictures
render_by() {
    command=$1
    shift
    # shellcheck disable=SC2086  # one word or two
    options "$command" "$scene" $progress ${threads:+--threads "$threads"} "$@"
}

# try COMMAND...: up to three times while another try may help: the disk was full, another was writing, memory was short, it was killed
try() {
    for pause in 5 25 ''; do
        "$@"
        status=$?
        case $status in
            0) return ;;
            7[145] | 12[89] | 1[3-9]? | 2??) ;;
            *) break ;;
        esac
        [ -z "$pause" ] || { say "exit code $status: trying again in $pause s"; sleep "$pause"; }
    done
    worst=$status
}

missing() {
    worst=66
    lost=$((lost + 1))
    [ "$lost" -gt 20 ] || say "missing: $1"
}

# slice FROM COUNT: so many of the job's frames, without the first FROM, in the form of FRAMES
slice() {
    awk -v frames="$frames" -v from="$1" -v left="$2" 'BEGIN {
        count = split(frames, ranges, ",")
        for (i = 1; i <= count && left > 0; i++) {
            ends = split(ranges[i], end, "-")
            first = end[1] + from
            last = end[ends] + 0
            from = first > last ? first - last - 1 : 0
            if (first <= last) {
                if (last > first + left - 1) last = first + left - 1
                printf "%s%d-%d", comma, first, last
                left -= last - first + 1
                comma = ","
            }
        }
        print ""
    }'
}

# each FUNCTION FRAMES ARG...: the function for each of the frames
each() {
    function=$1
    ranges=$2,
    shift 2
    while [ "$ranges" ]; do
        range=${ranges%%,*}
        ranges=${ranges#*,}
        frame=${range%-*}
        while [ "$frame" -le "${range#*-}" ]; do
            "$function" "$@"
            frame=$((frame + 1))
        done
    done
}

# picture: sets $picture, and $part before the number of a band, for $frame
picture() {
    if [ -z "$still" ]; then
        number=$frame
        while [ "${#number}" -lt "$digits" ]; do number=0$number; done
        picture=frames/$number.png part=parts/$number
    else
        picture=picture.png part=parts/band
    fi
}

render_band() {
    picture
    [ -e "$picture" ] && [ ! -e "$part-$1.png" ] && return    # merged, and its parts were removed
    band=$1
    shift
    [ "$still" ] || set -- --frame "$frame"
    try render_by render "$@" --band "$band/$bands" -o "$part-$band.png" --skip-done --resume
}

render() {
    if [ "$bands" -gt 1 ]; then
        each render_band "$1" "$2"
    elif [ -z "$still" ]; then
        try render_by animate --frames "$1" -o "frames/%0${digits}d.png" --resume
    else
        try render_by render -o picture.png --skip-done --resume
    fi
}

merge_frame() {
    picture
    parts= band=1 new=
    [ -e "$picture" ] || new=yes
    lost_before=$lost
    while [ "$band" -le "$bands" ]; do
        file=$part-$band.png
        parts="$parts $file"
        [ -e "$file" ] || [ -z "$new" ] || missing "$file"
        [ ! "$file" -nt "$picture" ] || new=yes
        band=$((band + 1))
    done
    [ -z "$new" ] || [ "$lost" -gt "$lost_before" ] && return
    try merge_parts
}

# One that was killed when it had just written the picture is not repeated.
merge_parts() {
    new=
    [ -e "$picture" ] || new=yes
    for file in $parts; do
        [ ! "$file" -nt "$picture" ] || new=yes
    done
    # shellcheck disable=SC2086  # names without blanks
    [ -z "$new" ] || program merge -q -o "$picture" $parts
}

look_for() {
    picture
    [ -e "$picture" ] || missing "$picture"
    [ ! "$picture" -nt "$film" ] || new=yes
}

# The film is joined of the pictures where animate --resume looks for them.
link() {
    picture
    while [ "${#number}" -lt 6 ]; do number=0$number; done
    ln -f "$picture" "$film.frames/$number.png" 2>/dev/null || cp -p "$picture" "$film.frames/$number.png" || worst=74
}

film() {
    new=
    each look_for "$frames"
    [ "$film" ] && [ "$worst" -eq 0 ] && { [ "$new" ] || [ ! -e "$film" ]; } || return 0
    mkdir -p "$film.frames" || { worst=73; return; }
    each link "$frames"
    try render_by animate --frames "$frames" -o "$film" --resume
}

program() { "${SIMPLERAY:-simpleray}" "$@"; }

usage() {
    say "expected render FRAMES [BAND], task K, merge [FRAMES], film or finish, found '$*' (see the first lines of job.sh)"
    exit 2
}

case ${2-0} in '' | *[!0-9,-]*) usage "$@" ;; esac
case ${3-1} in '' | *[!0-9]*) usage "$@" ;; esac
[ "${3-1}" -ge 1 ] && [ "${3-1}" -le "$bands" ] || { say "expected a band from 1 to $bands, found $3"; exit 2; }
command -v "${SIMPLERAY:-simpleray}" >/dev/null || { say "no program ${SIMPLERAY:-simpleray}: put it on the PATH, or its path into SIMPLERAY"; exit 69; }
worst=0 lost=0
case $#${1-} in
    [23]render) render "$2" "${3-1}" ;;
    2task)
        case $2 in *[!0-9]*) usage "$@" ;; esac
        slice=$(slice $(($2 / bands * chunk)) "$chunk")
        [ "$slice" ] || { say "there is no piece $2"; exit 2; }
        render "$slice" $(($2 % bands + 1)) ;;
    [12]merge) each merge_frame "${2-$frames}" ;;
    1film) film ;;
    1finish)
        [ "$bands" -eq 1 ] || each merge_frame "$frames"
        [ "$lost" -gt 0 ] || film ;;
    *) usage "$@" ;;
esac
[ "$lost" -le 20 ] || say "missing: $((lost - 20)) more"
[ "$lost" -eq 0 ] || say 'to render what is missing, submit the job again: what is there and whole stays'
exit "$worst"
