#!/usr/bin/env bash
# Installs Debian packages of ours in a clean Debian, uses them as their owner would (installed.sh), removes them. Needs root and
# debootstrap. FOLDER keeps the clean system, a compiler in it and beside it what ours depend on: the next run needs no network.
# usage: tests/package/clean_system.sh FOLDER DEB…
set -euo pipefail

here=$(dirname "$(realpath "$0")")
mkdir -p "$1"
folder=$(realpath "$1") base=$folder/base
debs=("${@:2}")
source /etc/os-release

inside() { # a command in a system, with processes of its own
  unshare --mount --pid --fork --kill-child --mount-proc --root="$1" \
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "${@:2}"
}

# This machine's own sources of its distribution.
sources() {
  apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' | grep " $VERSION_CODENAME" | sort -u
}

make_base() {
  local mirror new=$folder/new
  rm -rf "$new"
  mirror=$(sources | awk -v release="$VERSION_CODENAME" '$3 == release {print $2; exit}')
  debootstrap --variant=minbase --include=g++,pkg-config,ca-certificates "$VERSION_CODENAME" "$new" "$mirror"
  rm -f "$new"/var/cache/apt/archives/*.deb
  sources >"$new/etc/apt/sources.list"
  apt-config dump Acquire >"$new/etc/apt/apt.conf.d/acquire"
  echo force-unsafe-io >"$new/etc/dpkg/dpkg.cfg.d/unsafe-io"
  cp /etc/resolv.conf /etc/hosts "$new/etc/"
  cp "${debs[@]}" "$new/tmp/"
  inside "$new" apt-get -q update
  inside "$new" apt-get -qy install --no-install-recommends --download-only "${debs[@]/#*\///tmp/}"
  rm -f "$new"/tmp/*.deb
  mv "$new" "$base"
}

if [[ ! -d $base ]] && ! make_base >"$folder/base.log" 2>&1; then
  tail -n 20 "$folder/base.log"
  exit 1
fi

# What changes stays in memory, and is gone at the end.
export here base
unshare --mount --pid --fork --kill-child bash -euc '
  over=$(dirname "$base")/over
  mkdir -p "$over"
  mount -t tmpfs tmpfs "$over"
  mkdir "$over"/{changes,work,root}
  mount -t overlay overlay -o "lowerdir=$base,upperdir=$over/changes,workdir=$over/work" "$over/root"
  mount -t proc proc "$over/root/proc"
  cp "$@" "$here"/{installed.sh,consumer.cpp} "$over/root/tmp/"
  cd "$over/root/tmp"
  exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot .. bash /tmp/installed.sh
' bash "${debs[@]}"
