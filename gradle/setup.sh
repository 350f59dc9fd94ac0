# Sourced by ./simpleray and ./check, which set $me (their name) and $root.  POSIX sh.
# Finds, and as root on Debian or Ubuntu installs, a JDK and a Gradle; on a terminal it asks before.
# Everything here prints to stderr only; a failure ends the script with one line that says what to install.
# shellcheck shell=sh disable=SC2015,SC2034,SC2154

say() { printf '%s: %s\n' "$me" "$*" >&2; }
die() { say "$@"; exit 70; }
have() { command -v "$1" >/dev/null 2>&1; }

# agreed PACKAGE...: whether they may be installed: as $SIMPLERAY_INSTALL says, else as the user does; yes where there is no terminal
agreed() {
    case ${SIMPLERAY_INSTALL-} in
        [Nn]* | 0 | false) return 1 ;;
        [Yy]* | 1 | true) return 0 ;;
    esac
    [ -t 0 ] || [ -t 1 ] || [ -t 2 ] || return 0
    [ -t 2 ] || return 1                         # nobody would see the question
    printf '%s: install %s by apt-get? [y/N] ' "$me" "$*" >&2
    answer=
    if [ -t 0 ]; then read -r answer; else read -r answer 2>/dev/null </dev/tty; fi || echo >&2
    case $answer in [Yy]*) return 0 ;; esac
    SIMPLERAY_INSTALL=no                         # one answer is enough
    return 1
}

# install PACKAGE...: false when this is not Debian, not root, not wanted, or when apt-get fails
install() {
    have apt-get && [ "$(id -u)" = 0 ] && agreed "$@" || return 1
    say "installing $*"
    if [ -z "${apt_updated-}" ]; then
        apt-get -qq update </dev/null >&2 || say 'apt-get update failed: going on with the old lists'
        apt_updated=1
    fi
    DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 install --no-install-recommends "$@" \
        </dev/null >&2
}

# Names of files need UTF-8: takes C.UTF-8 when the locale in force is another.
use_utf8() {
    case ${LC_ALL:-${LC_CTYPE:-${LANG-}}} in
        C.UTF-8 | C.utf8) return ;;
        *[Uu][Tt][Ff]-8* | *[Uu][Tt][Ff]8*)      # a name alone does not make a locale: it may not be installed
            have locale || return 0
            case $(locale charmap 2>/dev/null) in UTF-8 | '') return ;; esac ;;
    esac
    [ ! -x /usr/libexec/java_home ] || return 0  # macOS: always UTF-8 there
    LC_ALL=C.UTF-8
    export LC_ALL
}

# java_version HOME: sets $version to the feature release (17) of the Java there, or to 0, and $build to all that it says of its version
java_version() {
    version='' build=''
    if [ -r "$1/release" ]; then
        while IFS='="' read -r key _ value _; do
            [ "$key" = JAVA_RUNTIME_VERSION ] && build=$value
            [ "$key" = JAVA_VERSION ] && version=$value && break
        done <"$1/release"
    fi
    if [ -z "$version" ] && [ -x "$1/bin/java" ]; then
        version=$("$1/bin/java" -version 2>&1 </dev/null | sed -n 's/.* version "\([^"]*\)".*/\1/p')
    fi
    version=${version#1.}                        # 1.8.0_202 is Java 8
    version=${version%%[!0-9]*}
    version=${version:-0}
    build=${build:-$version}
}

# home_of COMMAND: sets $home to the Java home that the `java` or `javac` on the PATH belongs to
home_of() {
    home=$(command -v "$1" 2>/dev/null) || { home=; return 1; }
    if [ "$home" = /usr/bin/"$1" ] && [ -x /usr/libexec/java_home ]; then
        home=$(/usr/libexec/java_home -v 17+ 2>/dev/null)   # macOS: /usr/bin/java is a stand-in
    else
        home=$(readlink -f "$home" 2>/dev/null || printf %s "$home")
        home=${home%/bin/"$1"}
        home=${home%/jre}
    fi
    [ -x "$home/bin/$1" ]
}

# find_java: sets $java to a Java 17 or later to run the program with
find_java() {
    if [ -n "${JAVA_HOME-}" ] && [ -x "$JAVA_HOME/bin/java" ]; then
        java_version "$JAVA_HOME"
        [ "$version" -ge 17 ] && java=$JAVA_HOME/bin/java && return
    fi
    if home_of java; then
        java_version "$home"
        [ "$version" -ge 17 ] && java=$home/bin/java && return
    fi
    find_jdk 99 && java=$jdk/bin/java
}

# old_java: prints which Java there is when it is too old, in parentheses
old_java() {
    home=${JAVA_HOME:-/none}
    [ -x "$home/bin/java" ] || home_of java || return 0
    java_version "$home"
    case $version in
        0) printf ' (%s is none that tells its version)' "$home/bin/java" ;;
        ? | 1[0-6]) printf ' (%s is Java %s)' "$home/bin/java" "$version" ;;
    esac
}

# find_jdk MAX: sets $jdk to the home of a JDK (with javac) from 17 to MAX, the one in use before others
find_jdk() {
    home_of javac
    for jdk in "${JAVA_HOME-}" "$home" /usr/lib/jvm/java-17-* /usr/lib/jvm/default-java /usr/lib/jvm/* \
        /Library/Java/JavaVirtualMachines/*/Contents/Home "${HOME-}"/.sdkman/candidates/java/*; do
        [ -n "$jdk" ] && [ -x "$jdk/bin/java" ] && [ -x "$jdk/bin/javac" ] || continue
        java_version "$jdk"
        [ "$version" -ge 17 ] && [ "$version" -le "$1" ] && return
    done
    jdk=
    return 1
}

# need_jdk MAX WHY: as find_jdk, but installs one or ends the script
need_jdk() {
    find_jdk "$1" && return
    { install openjdk-17-jdk || install default-jdk; } && find_jdk "$1" && return
    die "$2$(old_java): install it (Debian: apt-get install openjdk-17-jdk)"
}

# gradle_jdk COMMAND: sets $max to the last Java that this Gradle runs on; false when it is no use
gradle_jdk() {
    release=$(JAVA_HOME=$jdk "$1" --version </dev/null 2>/dev/null | sed -n 's/^Gradle \([0-9.]*\).*/\1/p')
    case $release in
        '') return 1 ;;
        4.4.1) max=17 ;;                         # Debian's, which has been taught Java 17
        [1-6] | [1-6].* | 7.[0-2] | 7.[0-2].*) return 1 ;;
        7.* | 8.[0-4] | 8.[0-4].*) max=17 ;;
        8.[5-9] | 8.[5-9].*) max=21 ;;
        8.1[0-3] | 8.1[0-3].*) max=23 ;;
        8.* | 9.0 | 9.0.*) max=24 ;;
        *) max=99 ;;
    esac
}

# need_gradle: sets $gradle (a command) and $jdk (what it runs on)
need_gradle() {
    # that of a user whom /etc/passwd does not know would be called `?`
    id -un >/dev/null 2>&1 || export GRADLE_USER_HOME="${GRADLE_USER_HOME:-$root/build/gradle}"
    find_jdk 17 || find_jdk 23 || need_jdk 99 'no JDK 17 or later'
    gradle=gradle
    if ! have gradle || ! gradle_jdk gradle; then
        gradle=$root/gradlew
        set -- "$gradle"
        have timeout && set -- timeout 600 "$gradle"    # the first time it downloads Gradle, if it can
        if ! { [ -x "$gradle" ] && JAVA_HOME=$jdk "$@" --version </dev/null >/dev/null 2>&1 && gradle_jdk "$gradle"; }
        then
            gradle=gradle
            install gradle && gradle_jdk gradle ||
                die 'no Gradle that works: install one (Debian: apt-get install gradle)'
        fi
    fi
    if [ "$release" = 4.4.1 ] && ! find_jdk 17 && [ -x /usr/lib/jvm/default-java/bin/javac ]; then
        jdk=/usr/lib/jvm/default-java            # a later Debian's Gradle runs on that Debian's own JDK
    else
        need_jdk "$max" "no JDK that Gradle $release runs on (17 to $max)"
    fi
}

# run_gradle ARG...: in the project's folder, on $jdk, with nothing left running
run_gradle() (
    cd "$root" || exit
    JAVA_HOME=$jdk
    export JAVA_HOME
    exec "$gradle" --no-daemon --console=plain "$@" </dev/null
)
