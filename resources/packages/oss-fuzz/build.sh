#!/usr/bin/env bash
# Builds all fuzz targets for OSS-Fuzz into $OUT, each with its seeds as TARGET_seed_corpus.zip.
set -euo pipefail
# The distribution's libraries of C++ are built with its own standard library.
CXXFLAGS=${CXXFLAGS//-stdlib=libc++/}

cmake -S "$SRC/copperscope" -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCOPPERSCOPE_GUI=OFF -DCOPPERSCOPE_FUZZ=ON \
    -DCOPPERSCOPE_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" -DCMAKE_CXX_FLAGS="$CXXFLAGS"
cmake --build "$WORK/build" --target fuzzers

# The machine that fuzzes has none of the libraries: they go along, and are looked for beside the target. So are those that only they need, for
# which the older kind of path counts (RPATH).
mkdir -p "$OUT/lib"
while read -r target; do
    program=$WORK/build/tests/fuzz_$target
    ldd "$program" | awk '$3 ~ /^\// {print $3}' | grep -vE '/(libc|libm|libpthread|libdl|librt|libgcc_s)\.so' | xargs -r cp -nt "$OUT/lib"
    cp "$program" "$OUT/"
    patchelf --force-rpath --set-rpath "\$ORIGIN/lib" "$OUT/fuzz_$target"
    zip -qj "$OUT/fuzz_${target}_seed_corpus.zip" "$WORK/seeds/$target"/*
done < <("$WORK/build/tests/write_seeds" "$WORK/seeds")
