// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/Crowns.h"

#include "commands/GrowGesture.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <memory>

namespace espalier::test {

double cpuTime()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> samples)
{
    if (samples.empty())
        return 0.0;
    const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    std::ranges::nth_element(samples, middle);
    return *middle;
}

double worst(const std::vector<double>& samples)
{
    return samples.empty() ? 0.0 : *std::ranges::max_element(samples);
}

void growTo(TreeDocument& document, std::uint32_t internodes)
{
    GrowGesture growth(document);
    while (document.index().livingCount() < internodes && growth.step()) {
    }
    growth.finish();
}

TreeDocument& crown(std::uint32_t internodes)
{
    static std::map<std::uint32_t, std::unique_ptr<TreeDocument>> crowns;
    std::unique_ptr<TreeDocument>& document = crowns[internodes];
    if (!document) {
        document = std::make_unique<TreeDocument>();
        growTo(*document, internodes);
    }
    return *document;
}

} // namespace espalier::test
