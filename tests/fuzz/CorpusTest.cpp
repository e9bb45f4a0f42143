// SPDX-License-Identifier: GPL-3.0-or-later
// Reads every input of tests/fuzz/corpus, and damaged ones made of them: no crash, and none takes a second.
// The long run is libFuzzer's; see scripts/nightly.sh.
#include "tests/fuzz/Mutator.h"
#include "tests/fuzz/Targets.h"

#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QGuiApplication>

#include <cstdio>
#include <vector>

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

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_LOGGING_RULES", "*.warning=false");
    const QGuiApplication application(argc, argv);
    constexpr int kDamaged = 150;     ///< Of each target
    constexpr qint64 kLongest = 1000; // ms
    int count = 0;
    for (const FuzzTarget& target : fuzzTargets()) {
        std::vector<QByteArray> inputs = inputsOf(target);
        if (inputs.empty()) {
            std::printf("FAIL: there is no corpus of %s\n", target.name);
            return 1;
        }
        Mutator mutator(9);
        const std::size_t whole = inputs.size();
        for (int i = 0; i < kDamaged; ++i) {
            const QByteArray donor = inputs[mutator.below(whole)];
            inputs.push_back(mutator.mutated(inputs[mutator.below(whole)], donor));
        }
        for (const QByteArray& input : inputs) {
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
    std::printf("%d inputs\n", count);
    return 0;
}
