# Shared by the scripts: sourced, never run. Goes to the top of the tree.

cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly python=/usr/bin/python3 # another python3 on PATH may lack the packages that script/bootstrap installs
readonly cli=build/release/bin/linkwright

fail() {
  printf '%s: %s\n' "script/$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}

# The Node that script/bootstrap got, where the system's is too old.
use_kept_node() {
  if [[ -x build/node/bin/node ]]; then export PATH="$PWD/build/node/bin:$PATH"; fi
}
use_kept_node

# Configures a preset and builds targets of it (all), quietly: one line, or the log of what went wrong.
build_preset() {
  local preset=$1 start=$SECONDS log
  local targets=("${@:2}")
  log="build/$preset.log"
  command -v cmake >/dev/null || fail "cmake is missing: run script/bootstrap first"
  mkdir -p build
  printf 'build/%s: ' "$preset"
  if ! { cmake --preset "$preset" && cmake --build --preset "$preset" --parallel "$(nproc)" ${targets:+--target "${targets[@]}"} -- -k 0; } >"$log" 2>&1; then
    printf 'failed\n'
    cut -c1-1000 "$log"
    return 1
  fi
  printf 'built in %d s\n' $((SECONDS - start))
}

# The workbench: its engine (WebAssembly), the picture of the example that is shown until the engine is ready, the page.
build_web() {
  local start log=build/web.log
  build_preset wasm || return
  start=$SECONDS
  printf 'build/web: '
  if ! { npm --prefix web run --silent bake && npm --prefix web run --silent build; } >"$log" 2>&1; then
    printf 'failed\n'
    cut -c1-300 "$log"
    return 1
  fi
  printf 'built in %d s\n' $((SECONDS - start))
}

# The version, from its one place.
project_version() { sed -nE 's/^project\(linkwright VERSION ([0-9.]+).*/\1/p' CMakeLists.txt; }

# Clones of the tree share what was compiled, wherever they lie.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

# What is made twice from one commit is the same to the last bit: files are as old as it is.
export SOURCE_DATE_EPOCH
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CMakeLists.txt)

# The Debian packages into a folder; the program and the page are built.
make_debs() {
  rm -rf "$1" && mkdir -p "$1"
  cpack --config build/release/CPackConfig.cmake -B "$PWD/$1" >"$1.log" 2>&1 || { cat "$1.log" && return 1; }
  rm -rf "$1/_CPack_Packages"
}

# The C++ files of the tree, one a line: all that git knows or would know; without git, all there are.
cpp_files() {
  local folders=(include src apps bindings tests bench fuzz) folder present=()
  for folder in "${folders[@]}"; do [[ -d $folder ]] && present+=("$folder"); done
  { git ls-files --cached --others --exclude-standard -- "${present[@]}" 2>/dev/null ||
    find "${present[@]}" -type f; } | grep -E '\.[ch]pp$' | sort -u |
    while IFS= read -r file; do if [[ -f $file ]]; then printf '%s\n' "$file"; fi; done
}
