// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/Soak.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>

/// Without options, the short soak that is one of the tests.
int main(int argc, char** argv)
{
    using namespace espalier::test;
    const QCoreApplication application(argc, argv);
    SoakOptions options;
    const QCommandLineOption operations(QStringLiteral("operations"), QStringLiteral("How many."),
                                        QStringLiteral("count"), QString::number(options.operations));
    const QCommandLineOption seed(QStringLiteral("seed"), QStringLiteral("Another seed, another tree."),
                                  QStringLiteral("number"), QString::number(options.seed));
    const QCommandLineOption history(
        QStringLiteral("history"),
        QStringLiteral("Shortens histories that take more memory; 0: shortens none."), QStringLiteral("MB"),
        QStringLiteral("0.3"));
    const QCommandLineOption keep(QStringLiteral("keep"), QStringLiteral("Keeps the recipe."));
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Random operations of all kinds, saved and read back now "
                                                    "and then, must lead where their recipe leads."));
    parser.addHelpOption();
    parser.addOptions({operations, seed, history, keep});
    parser.process(application);
    bool isCount = false;
    bool isSeed = false;
    options.operations = parser.value(operations).toInt(&isCount);
    options.seed = parser.value(seed).toULongLong(&isSeed);
    options.mostHistory = static_cast<std::size_t>(parser.value(history).toDouble() * 1e6);
    if (!isCount || !isSeed || options.operations < 1)
        parser.showHelp(2);

    // Saving and checking cost more the longer the history is.
    options.saveEvery = std::max(options.saveEvery, options.operations / 120);
    options.checkEvery = std::max(options.checkEvery, options.operations / 60);

    QElapsedTimer timer;
    timer.start();
    Soak soak(options, QStringLiteral("soak-%1.json").arg(options.seed));
    const QString fault = soak.run();
    std::printf("seed %llu: %s; %.1f s\n", static_cast<unsigned long long>(options.seed),
                qPrintable(soak.figures()), 1e-3 * static_cast<double>(timer.elapsed()));
    if (!fault.isEmpty()) {
        std::printf("FAIL: after operation %d: %s\nThe recipe so far: %s\n", soak.operationsDone() - 1,
                    qPrintable(fault), qPrintable(soak.log().fileName()));
        return 1;
    }
    if (!parser.isSet(keep))
        soak.log().remove();
    return 0;
}
