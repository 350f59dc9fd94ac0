#!/bin/sh
# deb.sh APP VERSION FOLDER: makes a Debian package of APP, which gradle appImage has made, in FOLDER.  Called by gradle deb.
# The package runs no scripts when it is installed or removed: what dpkg unpacks is all there is, and it removes that.
# The same APP makes the same package, byte for byte: its files are root's, and as old as $SOURCE_DATE_EPOCH says.
# shellcheck disable=SC2015  # a && b || c: c also when b fails
me='gradle deb'
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P) || exit 70
. "$root/gradle/setup.sh"
app=$1 version=$2 folder=$3
use_utf8
set -e
umask 022

have dpkg-deb || die 'no dpkg-deb: Debian packages are made on Debian'
have dpkg-shlibdeps && have objdump || install dpkg-dev binutils && have dpkg-shlibdeps && have objdump ||
    die 'no dpkg-shlibdeps or objdump: install them (Debian: apt-get install dpkg-dev binutils)'

rm -rf "$folder"
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
image=$work/image
share=$image/usr/share
mkdir -p "$image/DEBIAN" "$image/usr/bin" "$share/applications" "$share/doc/simpleray" "$share/man/man1" \
    "$share/icons/hicolor/256x256/apps" "$image/usr/lib/simpleray"

cp -a "$app/lib/runtime" "$app/lib/app/simpleray.jar" "$image/usr/lib/simpleray"
java=$image/usr/lib/simpleray/runtime
cat >"$image/usr/bin/simpleray" <<'END'
#!/bin/sh
# SimpleRay by the Java that comes with it; $SIMPLERAY_OPTS holds options for the JVM.
here=$(dirname -- "$(readlink -f -- "$0")")/../lib/simpleray
case ${LC_ALL:-${LC_CTYPE:-${LANG:-C}}} in C | POSIX) export LC_ALL=C.UTF-8 ;; esac    # names of files need UTF-8
options=-XX:-UsePerfData
case ${1-} in render) options="$options -XX:+UseSerialGC -XX:NewRatio=4 -XX:MinHeapFreeRatio=10 -XX:MaxHeapFreeRatio=25" ;; esac
# A JVM that does not start for an option ends with 1, as verify does if pictures differ: it is tried, unless it would do something twice.
case ${SIMPLERAY_OPTS-}${JAVA_TOOL_OPTIONS-}${JDK_JAVA_OPTIONS-}${_JAVA_OPTIONS-} in
    '' | *jdwp* | *Archive* | *AOT* | *Recording*) ;;
    *)
        # shellcheck disable=SC2086
        said=$("$here/runtime/bin/java" $options ${SIMPLERAY_OPTS-} --dry-run -jar "$here/simpleray.jar" </dev/null 2>&1) || {
            printf 'simpleray: Java does not start: %s\n' "$said" >&2
            exit 70
        } ;;
esac
# shellcheck disable=SC2086
exec "$here/runtime/bin/java" $options ${SIMPLERAY_OPTS-} -jar "$here/simpleray.jar" "$@"
END
chmod +x "$image/usr/bin/simpleray"
cp "$root/LICENSE" "$share/doc/simpleray/copyright"
cp "$app/lib/SimpleRay.png" "$share/icons/hicolor/256x256/apps/simpleray.png"
cat >"$share/applications/simpleray.desktop" <<END
[Desktop Entry]
Type=Application
Name=SimpleRay
Comment=A ray tracer
Exec=simpleray %f
Icon=simpleray
Categories=Graphics;3DGraphics;
StartupWMClass=simpleray-cli-Main
END

# The man page is what --help says of the program and of each command.
help() { SIMPLERAY_OPTS='-XX:TieredStopAtLevel=1 -Dpicocli.usage.width=72' "$image/usr/bin/simpleray" "$@" --help </dev/null; }
verbatim() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\\&&/"; }
{
    printf '.TH SIMPLERAY 1 "" "SimpleRay %s" "User Commands"\n.SH NAME\n' "$version"
    printf 'simpleray \\- make realistic pictures of scenes by ray tracing\n'
    help | verbatim | awk '
        function section(name) { print ".fi\n.SH " toupper(name) "\n.nf" }
        NR == 1 { next }
        sub(/^Usage: /, "") { section("synopsis"); usage = 1 }
        /^$/ && usage { section("description"); usage = 0 }
        /^[A-Z][A-Za-z ]*:$/ { section(substr($0, 1, length($0) - 1)); next }
        usage { sub(/^ +/, "") }
        { print }'
    for command in $(help | sed -n '/^Commands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'); do
        printf '.fi\n.SH SIMPLERAY %s\n.nf\n' "$(echo "$command" | tr '[:lower:]' '[:upper:]')"
        help "$command" | verbatim
    done
} | gzip -9n >"$share/man/man1/simpleray.1.gz"

find "$image" -type d -exec chmod 755 {} +
find "$image" -type f -perm -u+x -exec chmod 755 {} +
find "$image" -type f ! -perm -u+x -exec chmod 644 {} +

# Which packages hold the system's libraries that the Java inside is linked to
mkdir "$work/debian"
printf 'Source: simpleray\n\nPackage: simpleray\nArchitecture: any\n' >"$work/debian/control"
libraries=$(cd "$work" && find "$java" -type f \( -name '*.so' -o -perm -u+x \) -exec \
    dpkg-shlibdeps -O --ignore-missing-info "-l$java/lib" "-l$java/lib/server" {} + 2>"$work/log") || { cat "$work/log" >&2; exit 70; }

cat >"$image/DEBIAN/control" <<END
Package: simpleray
Version: $version
Architecture: $(dpkg --print-architecture)
Section: graphics
Priority: optional
Maintainer: SimpleRay
Installed-Size: $(find "$image/usr" -type f -printf '%s\n' | awk '{ size += $1 } END { print int(size / 1024) }')
Depends: ${libraries#shlibs:Depends=}, libfontconfig1
Recommends: fonts-dejavu-core
Description: ray tracer with a window and a command line
 SimpleRay makes realistic pictures of scenes that a text file describes: spheres,
 planes, triangles, cylinders, cones, meshes and lights. It brings the Java it needs.
END
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-318211200} \
    dpkg-deb --root-owner-group -Zxz --build "$image" "$folder" >/dev/null
