# Shared by the scripts: sourced, never run. Goes to the top of the tree.

cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly python=/usr/bin/python3 # another python3 on PATH may lack the packages that script/bootstrap installs
readonly cli=build/release/bin/linkwright

fail() {
  printf '%s: %s\n' "script/$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}

# Configures and builds a preset, quietly: one line, or the log of what went wrong.
build_preset() {
  local preset=$1 start=$SECONDS log
  log="build/$preset.log"
  command -v cmake >/dev/null || fail "cmake is missing: run script/bootstrap first"
  mkdir -p build
  printf 'build/%s: ' "$preset"
  if ! { cmake --preset "$preset" && cmake --build --preset "$preset" --parallel "$(nproc)" -- -k 0; } >"$log" 2>&1; then
    printf 'failed\n'
    cat "$log"
    return 1
  fi
  printf 'built in %d s\n' $((SECONDS - start))
}

# The C++ files of the tree, one a line: all that git knows or would know; without git, all there are.
cpp_files() {
  local folders=(include src apps bindings tests bench fuzz) folder present=()
  for folder in "${folders[@]}"; do [[ -d $folder ]] && present+=("$folder"); done
  { git ls-files --cached --others --exclude-standard -- "${present[@]}" 2>/dev/null ||
    find "${present[@]}" -type f; } | grep -E '\.[ch]pp$' | sort -u |
    while IFS= read -r file; do if [[ -f $file ]]; then printf '%s\n' "$file"; fi; done
}
