# Inside of a clean Debian, packages of ours in /tmp: installs them, uses them as their owner would, removes them.
set -euo pipefail
cd /tmp

check() { "${@:2}" || { printf 'not so: %s\n' "$1" >&2 && exit 1; }; }
apt() { apt-get -qq "$@" >>apt.log 2>&1; }
get() { # the studio's answer
  exec 3<>/dev/tcp/127.0.0.1/4180
  printf 'GET %s HTTP/1.0\r\nHost: 127.0.0.1:4180\r\n\r\n' "$1" >&3
  cat <&3
}

packages=$(for deb in *.deb; do dpkg-deb --field "$deb" Package; done)
apt install --no-install-recommends ./*.deb || { apt update && apt install --no-install-recommends ./*.deb; } || { cat apt.log && exit 1; }

check "the program says its version" [ "$(linkwright --version)" = "linkwright $(dpkg-query -W -f='${Version}' linkwright)" ]
linkwright solve /usr/share/doc/linkwright/examples/tailgate.json -o result.json --svg tailgate.svg >answer.txt
check "the tailgate's best linkage is the known one" grep -q 'Linkage 1 has the largest minimum transmission angle, 83.66°' answer.txt
check "a picture is drawn" grep -q '</svg>' tailgate.svg
if [[ -e $(compgen -G "linkwright-step_*.deb") ]]; then
  linkwright export result.json --format step -o tailgate.step
  check "an assembly is written for CAD" grep -q 'END-ISO-10303-21' tailgate.step
fi

linkwright studio --port 4180 >/dev/null &
studio=$!
for _ in {1..500}; do if { : >/dev/tcp/127.0.0.1/4180; } 2>/dev/null; then break; else sleep 0.1; fi; done
get / >page.txt
check "the studio serves the page" grep -q '<title>Linkwright' page.txt
check "the studio serves the page's script" grep -q text/javascript <(get "/$(grep -oE 'assets/index-[^"]+\.js' page.txt)")
kill $studio

check "the manual describes solve" grep -q region_samples <(zcat /usr/share/man/man1/linkwright-solve.1.gz)
if [[ -e $(compgen -G "linkwright-mpi_*.deb") ]]; then
  check "the manual describes sweeps on a cluster" grep -q resume <(zcat /usr/share/man/man1/linkwright-mpi-sweep.1.gz)
fi
source /usr/share/bash-completion/completions/linkwright
COMP_WORDS=(linkwright exp) COMP_CWORD=1
_linkwright
check "bash completes exp to export" [ "${COMPREPLY[*]}" = export ]

g++ -std=c++20 consumer.cpp -o consumer $(pkg-config --cflags --libs linkwright)
check "a program with the library runs" [ "$(./consumer)" = crank_rocker ]

apt purge $packages
apt autoremove --purge
check "nothing of it is left" [ -z "$(find / -xdev \( -path /tmp -o -path /proc \) -prune -o -iname '*linkwright*' -print)" ]
printf 'installed, used and removed in a clean system: %s\n' $packages
