// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Memory.h"

#include <benchmark/benchmark.h>

int main(int argc, char** argv)
{
    espalier::keepFreedMemory();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
