#!/usr/bin/env bash
# check_program.sh PROGRAM: that it is linked with nothing that talks to a network, starts programs or loads code by name. dlopen is for the one
# module of ours: who may call it is held by the ctest `architecture`, and that its path is a constant by those who read app/verify/step_file.cpp.
set -euo pipefail
program=$1
failures=0

violation() {
    echo "$*" >&2
    failures=$((failures + 1))
}

needed=$(readelf -d "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
[ -n "$needed" ] || violation "$program is linked with nothing: is it the program?"
for library in $needed; do
    case $library in
        *Network* | *WebEngine* | *WebSockets* | *DBus* | libcurl* | libssl* | libssh* | libsoup* | libpython* | liblua*) violation "it is linked with $library" ;;
    esac
done

used=$(nm -DC --undefined-only "$program" | sed 's/^ *[Uwv] //; s/@.*//; s/(.*//' | sort -u)
for name in socket connect bind listen accept accept4 sendto sendmsg recvfrom getaddrinfo gethostbyname \
    system popen fork vfork execl execle execlp execv execve execvp posix_spawn posix_spawnp dlmopen \
    QProcess::start QProcess::startDetached QDesktopServices::openUrl QLibrary::load QPluginLoader::load \
    archive_read_support_filter_all archive_read_support_filter_program archive_read_support_filter_lrzip archive_read_support_filter_grzip \
    archive_read_support_filter_lzop archive_write_disk_new archive_read_extract; do
    ! grep -qxF "$name" <<<"$used" || violation "it calls $name"
done
[ "$failures" -eq 0 ] || exit 1
echo "$(wc -l <<<"$used") names and $(wc -w <<<"$needed") libraries: no network, no programs, no plug-ins, nothing unpacked to the disk"
