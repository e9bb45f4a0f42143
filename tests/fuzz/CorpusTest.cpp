// SPDX-License-Identifier: GPL-3.0-or-later
// Reads every input of tests/fuzz/corpus, and damaged ones made of them: no crash, none takes a second, and
// all stay within half a gigabyte. Without sanitizers, whose own memory hides the program's; libFuzzer's long
// runs have them (scripts/nightly.sh).
#include "tests/fuzz/Mutator.h"
#include "tests/fuzz/Targets.h"

#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QGuiApplication>

#include <cstdio>
#include <vector>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace {

using namespace espalier::test;

std::vector<QByteArray> inputsOf(const FuzzTarget& target)
{
    std::vector<QByteArray> inputs;
    const QDir folder(QStringLiteral(SOURCE_DIR "/tests/fuzz/corpus/") + QLatin1String(target.name));
    for (const QFileInfo& file : folder.entryInfoList(QDir::Files, QDir::Name)) {
        QFile bytes(file.filePath());
        if (bytes.open(QIODevice::ReadOnly))
            inputs.push_back(bytes.readAll());
    }
    return inputs;
}

/// The most memory that the process has had so far; 0 where that is not known.
double peakMegabytes()
{
#ifdef Q_OS_LINUX
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
#else
    return 0.0;
#endif
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_LOGGING_RULES", "*.warning=false");
    const QGuiApplication application(argc, argv);
    const QCommandLineOption damaged(QStringLiteral("damaged"), QStringLiteral("Inputs of each target."),
                                     QStringLiteral("count"), QStringLiteral("150"));
    const QCommandLineOption seed(QStringLiteral("seed"), QStringLiteral("Other damage."),
                                  QStringLiteral("number"), QStringLiteral("9"));
    const QCommandLineOption only(QStringLiteral("target"), QStringLiteral("No other one."),
                                  QStringLiteral("name"));
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({damaged, seed, only});
    parser.process(application);
    constexpr qint64 kLongest = 1000; // ms
    int count = 0;
    for (const FuzzTarget& target : fuzzTargets()) {
        if (parser.isSet(only) && parser.value(only) != QLatin1StringView(target.name))
            continue;
        std::vector<QByteArray> inputs = inputsOf(target);
        if (inputs.empty()) {
            std::printf("FAIL: there is no corpus of %s\n", target.name);
            return 1;
        }
        Mutator mutator(parser.value(seed).toULongLong());
        const std::size_t whole = inputs.size();
        const std::size_t all = whole + parser.value(damaged).toULongLong();
        for (std::size_t i = 0; i < all; ++i) {
            const QByteArray donor = inputs[mutator.below(whole)];
            const QByteArray input =
                i < whole ? inputs[i] : mutator.mutated(inputs[mutator.below(whole)], donor);
            QElapsedTimer timer;
            timer.start();
            target.read(input);
            ++count;
            if (timer.elapsed() > kLongest) {
                std::printf("FAIL: an input of %s takes %lld ms\n", target.name,
                            static_cast<long long>(timer.elapsed()));
                return 1;
            }
        }
    }
    const double peak = peakMegabytes();
    std::printf("%d inputs, at most %.0f MB\n", count, peak);
    constexpr double kMostMegabytes = 512;
    if (peak > kMostMegabytes) {
        std::printf("FAIL: that is too much\n");
        return 1;
    }
    return 0;
}
