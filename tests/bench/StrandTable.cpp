// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what table 1 of Strands 2024 does: the time for the profiles and for the mesh of trees of the same
// numbers of nodes, and how it grows with the particles. Prints a table in Markdown; the paper's numbers are
// from a Core i9-10850K. An argument gives the number of runs of which the fastest counts.
#include "model/growth/VigourSpecies.h"
#include "model/mesh/StrandMesher.h"
#include "tests/bench/Crowns.h"

#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace espalier;

namespace {

/// A line of the paper's table.
struct PaperRow {
    const char* figure;
    std::uint32_t nodes;
    int perTip; ///< Strands that begin at each tip
    std::uint64_t strands;
    std::uint64_t particles;
    double profiles; ///< s
    double mesh;     ///< s
};

constexpr PaperRow kRows[] = {
    {"13a", 5'668, 1, 2'149, 95'976, 0.81, 0.48},      {"13b", 15'219, 1, 4'541, 357'276, 2.13, 1.51},
    {"13c", 21'425, 1, 6'252, 585'672, 3.29, 2.38},    {"13d", 32'256, 1, 9'389, 1'079'838, 5.26, 4.16},
    {"13e", 41'470, 1, 12'206, 1'602'270, 8.73, 6.09}, {"9b", 21'354, 4, 24'960, 2'258'528, 13.28, 10.31},
};
constexpr std::size_t kThreads[] = {1, 2};

struct Times {
    double profiles = 0.0;
    double mesh = 0.0;
};

Times measure(const TreeDocument& document, std::size_t threads, int runs)
{
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Widths widths(document.tree(), document.index());
    Times best;
    for (int i = 0; i < runs; ++i) {
        const auto now = [threads] {
            return threads == 1
                       ? test::cpuTime()
                       : std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
                             .count();
        };
        const double begin = now();
        const StrandLayouts layouts(document.tree(), document.index(), widths);
        const double middle = now();
        const BranchMesh mesh = meshStrands(layouts, document.parameters());
        const double end = now();
        if (mesh.indices.empty())
            std::abort();
        const Times times{middle - begin, end - middle};
        best.profiles = i == 0 ? times.profiles : std::min(best.profiles, times.profiles);
        best.mesh = i == 0 ? times.mesh : std::min(best.mesh, times.mesh);
    }
    return best;
}

/// The exponent e of y ~ x^e that fits best, by least squares of the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
    double sx = 0.0;
    double sy = 0.0;
    double sxx = 0.0;
    double sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = std::log(x[i]);
        const double v = std::log(y[i]);
        sx += u;
        sy += v;
        sxx += u * u;
        sxy += u * v;
    }
    const auto n = static_cast<double>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TreeParameters parametersOf(const PaperRow& row)
{
    TreeParameters parameters;
    parameters.growth.model = GrowthModelKind::Vigour;
    parameters.vigour = vigourSpecies()[1].parameters; // Oak
    parameters.wood.mesher = WoodMesherKind::Strands;
    parameters.wood.strandsPerTip = row.perTip;
    return parameters;
}

} // namespace

int main(int argc, char** argv)
{
    const int runs = std::max(1, argc > 1 ? std::atoi(argv[1]) : 3);
    std::printf("| figure | nodes, paper | nodes | strands, paper | strands | particles, paper | particles | "
                "profiles s, paper | "
                "1 thread | 2 threads | mesh s, paper | 1 thread | 2 threads |\n|%s\n",
                " --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    std::vector<double> particles;
    std::vector<double> paperParticles;
    std::vector<double> paperSum;
    std::vector<double> profiles[2];
    std::vector<double> meshes[2];
    for (const PaperRow& row : kRows) {
        TreeDocument document;
        document.reset(3, parametersOf(row));
        test::growTo(document, row.nodes);
        const Widths widths(document.tree(), document.index());
        const auto counts = StrandLayouts(document.tree(), document.index(), widths).count();
        Times times[2];
        for (std::size_t i = 0; i < 2; ++i) {
            times[i] = measure(document, kThreads[i], runs);
            profiles[i].push_back(times[i].profiles);
            meshes[i].push_back(times[i].mesh);
        }
        particles.push_back(static_cast<double>(counts.particles));
        paperParticles.push_back(static_cast<double>(row.particles));
        paperSum.push_back(row.profiles + row.mesh);
        std::printf(
            "| %s | %u | %u | %llu | %llu | %llu | %llu | %.2f | %.3f | %.3f | %.2f | %.2f | %.2f |\n",
            row.figure, row.nodes, document.index().livingCount(),
            static_cast<unsigned long long>(row.strands), static_cast<unsigned long long>(counts.strands),
            static_cast<unsigned long long>(row.particles), static_cast<unsigned long long>(counts.particles),
            row.profiles, times[0].profiles, times[1].profiles, row.mesh, times[0].mesh, times[1].mesh);
        std::fflush(stdout);
    }
    std::printf("\nTime grows with the particles to the power of: paper, both %.2f; profiles %.2f and %.2f, "
                "mesh %.2f and "
                "%.2f (1 and 2 threads)\n",
                exponent(paperParticles, paperSum), exponent(particles, profiles[0]),
                exponent(particles, profiles[1]), exponent(particles, meshes[0]),
                exponent(particles, meshes[1]));
    return 0;
}
