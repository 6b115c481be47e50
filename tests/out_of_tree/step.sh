# One step of the out-of-tree tests: step.sh install | headers | refused | build PROJECT [AS] | lists | meets PROJECT KIND ID
# FILE | run EXAMPLE FILE | measure | new KIND | new_refuses. The environment says where everything is; see CMakeLists.txt.
set -euo pipefail

prefix=$SCRATCH/prefix
package=$prefix/$LIBDIR/cmake/similitude
similitude=$prefix/bin/similitude
unset SIMILITUDE_PLUGIN_PATH similitude_DIR CMAKE_PREFIX_PATH
export XDG_DATA_HOME=$SCRATCH/empty   # no plugin of the user's own

fail() { echo "FAILED: $*" >&2; exit 1; }

# The text that a command must print while it fails; line breaks and indents count as one space.
expect_failure() {
  local wanted=$1
  shift
  local said
  if said=$("$@" 2>&1); then fail "this should not have worked: $*"; fi
  tr -s '[:space:]' ' ' <<<"$said" | grep -qF -- "$wanted" || fail "\"$wanted\" is not in: $said"
}

configure() {   # folder, then further options
  local folder=$1
  shift
  "$CMAKE" -S "$folder" -B "$folder/build" -G "$GENERATOR" -Dsimilitude_DIR="$package" "$@"
}

copy() {   # a fresh copy of a folder, away from the source tree
  rm -rf "${SCRATCH:?}/$2"
  cp -r "$1" "$SCRATCH/$2"
}

install_prefix() {
  rm -rf "$SCRATCH/first_prefix" "$prefix"
  mkdir -p "$SCRATCH/empty"
  "$CMAKE" --install "$BUILD" --prefix "$SCRATCH/first_prefix" >/dev/null
  mv "$SCRATCH/first_prefix" "$prefix"
  if grep -rlF -e "$SOURCE" -e "$BUILD" -e first_prefix "$package"; then fail "the package remembers where it was built"; fi
  if find "$prefix/bin" "$prefix/$LIBDIR" -name '*zoo*' -o -name '*test*' -o -name '*.a' | grep .; then fail "test libraries are installed"; fi
  if grep -rlE '#include *[<"]Eigen' "$prefix/include"; then fail "a header for plugins asks for Eigen"; fi
}

headers() {
  copy "$SOURCE/tests/out_of_tree/headers" headers
  configure "$SCRATCH/headers" -DINSTALLED_IN="$prefix"
  "$CMAKE" --build "$SCRATCH/headers/build"
}

refused() {
  copy "$SOURCE/tests/out_of_tree/refused" refused
  local folder=$SCRATCH/refused
  expect_failure "drag_law: -ffast-math is among its flags, and a plugin must not be built with it. Remove it: -fno-math-errno and -fno-trapping-math, which let loops vectorise, are set already." \
    configure "$folder" -DCMAKE_CXX_FLAGS=-ffast-math
  rm -rf "$folder/build"
  expect_failure "drag_law: -Ofast is among its flags" configure "$folder" -DLATE_OPTION=-Ofast
  rm -rf "$folder/build"
  expect_failure "similitude_add_plugin(law): there is no kind \"friction\". Use KIND with one of: drag;contact;fluid;scaling;effect." \
    configure "$folder" -DKIND=friction
  rm -rf "$folder/build"
  expect_failure "similitude_add_plugin(law): a fluid plugin links libsimilitude. Ask for it: find_package(similitude 1.0 REQUIRED COMPONENTS sdk framework)." \
    configure "$folder" -DKIND=fluid
  rm -rf "$folder/build"
  expect_failure "Similitude has no component \"gui\". Its components are sdk and framework." configure "$folder" -DCOMPONENT=gui
  rm -rf "$folder/build"
  expect_failure "that is compatible with requested version \"0.99\"" configure "$folder" -DWANTED=0.99
  rm -rf "$folder/build"
  expect_failure "similitude-config.cmake, version: $VERSION" configure "$folder" -DWANTED=0.99
  # A symbol that nobody defines is missed when linking, not when loading.
  rm -rf "$folder/build"
  configure "$folder" >/dev/null
  expect_failure "undefined reference to \`defined_nowhere" "$CMAKE" --build "$folder/build"
}

build() {   # an example or a folder beside this file, name of the copy
  local name=${2:-$1}
  local folder=$SOURCE/examples/$1
  [[ -d $folder ]] || folder=$SOURCE/tests/out_of_tree/$1
  copy "$folder" "$name"
  configure "$SCRATCH/$name"
  "$CMAKE" --build "$SCRATCH/$name/build"
  "$CMAKE" -E chdir "$SCRATCH/$name/build" ctest --output-on-failure --no-tests=ignore
  "$CMAKE" --install "$SCRATCH/$name/build" --prefix "$SCRATCH/$name/installed" >/dev/null
  [[ -f $SCRATCH/$name/installed/$LIBDIR/similitude/plugins/$(basename "$SCRATCH/$name"/build/*.so) ]] || fail "the plugin is not installed"
}

lists() {
  "$similitude" plugins failures | grep -qx "No file was refused." || fail "the installed program refuses a plugin of its own"
  local files
  files=$("$similitude" plugins list --json | grep '"file"')
  [[ -n $files ]] || fail "the installed program has no plugins"
  if grep -vF "$prefix/$LIBDIR/similitude/plugins/" <<<"$files"; then fail "a plugin does not come from the prefix"; fi
}

meets() {   # example, kind, id, file
  local found
  found=$(SIMILITUDE_PLUGIN_PATH=$SCRATCH/$1/build "$similitude" plugins info "$3")
  grep -qF "$3 1.0.0 ($2)" <<<"$found" || fail "$3 is not found: $found"
  grep -qF "$SCRATCH/$1/build/$4 (SIMILITUDE_PLUGIN_PATH)" <<<"$found" || fail "$3 is found elsewhere: $found"
  expect_failure "there is no model \"$3\"." "$similitude" plugins info "$3"
}

run() {   # example, file
  cd "$SCRATCH/$1"
  "$similitude" run case.yaml -o results --force --until "5 ms" --threads 1
  grep -qF "build/$2" results/manifest.json || fail "the manifest does not name $2"
}

# What the example for ParaView measures in its own files. Before the bed breaks up, at 0.05 s, the pressure is its README's to
# 2 %: later a bed of other instructions is another bed.
measure() {
  copy "$SOURCE/examples/05_paraview_view" 05_paraview_view
  cd "$SCRATCH/05_paraview_view"
  "$similitude" run case.yaml -o results --until "51 ms" --threads 1
  /usr/bin/python3 measure.py results measured.csv
  awk -F, '$1 == "0.050" { found = 1; if ($3 < 1.403 * 0.98 || $3 > 1.403 * 1.02) { print "pressure over weight:", $3; exit 1 } }
           END { if (!found) { print "there is no frame at 0.05 s"; exit 1 } }' measured.csv || fail "see above"
}

# A project that `plugins new` writes: its own three commands build it, test it and use it.
new() {   # kind
  local folder=$SCRATCH/new/$1
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder"
  export PATH=$prefix/bin:$PATH CMAKE_GENERATOR=$GENERATOR OMP_NUM_THREADS=1
  local said
  said=$(similitude plugins new "$1" "org.example.my-$1")
  echo "$said"
  if grep -r '@' "my_$1"; then fail "something was not filled in"; fi
  sed -n 's/^  //p' <<<"$said" >commands.sh
  [[ $(wc -l <commands.sh) == 3 ]] || fail "there are not three commands"
  bash -ex commands.sh 2>&1 | sed 's/^/  /'
  SIMILITUDE_PLUGIN_PATH=my_$1/build similitude plugins info "org.example.my-$1" | grep -qF "org.example.my-$1 1.0.0 ($1)" ||
    fail "the plugin is not found"
  grep -qF "my_$1/build/$1_my_$1.so" "my_$1/results/case/manifest.json" || fail "the run did not use it"
}

new_refuses() {
  local folder=$SCRATCH/new/refused
  rm -rf "$folder"
  mkdir -p "$folder/my_drag"
  cd "$folder"
  expect_failure 'error: ./my_drag is there already; nothing of it was changed. Remove it, choose another id, or name another folder with -o.' \
    "$similitude" plugins new drag my_drag
  [[ -z $(ls my_drag) ]] || fail "something was written"
  expect_failure 'error: there is no kind "friction". Use one of: drag, contact, fluid, scaling, effect.' \
    "$similitude" plugins new friction my_friction
  expect_failure 'error: "My Drag" is no id. Write my_law, or org.example.my_law to share it with others.' \
    "$similitude" plugins new drag "My Drag"
  expect_failure "the templates of plugins are not installed: $BUILD/share/similitude/templates/drag is not there. Install the Debian package similitude-dev, or type: cmake --install $BUILD --prefix PREFIX && PREFIX/bin/similitude plugins new …" \
    "$BUILD/bin/similitude" plugins new drag other_drag
}

step=$1
shift
case $step in
  install) install_prefix ;;
  headers | refused | build | lists | meets | run | measure | new | new_refuses) $step "$@" ;;
  *) fail "there is no step $step" ;;
esac
