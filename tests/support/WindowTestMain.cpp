// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Theme.h"
#include "tests/support/TestClasses.h"
#include "views/render/GlResources.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QtTest>

/// Runs every test class in an application with the program's style and with separate settings. If the first
/// argument is the name of a class, runs only that class, with the other arguments.
int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(espalier::surfaceFormat());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-test"));
    espalier::theme::apply(application);
    QStringList arguments = QCoreApplication::arguments();
    const auto nameOf = [](const QObject& test) {
        return QString::fromLatin1(test.metaObject()->className()).section(QLatin1String("::"), -1);
    };
    const QString first = arguments.value(1);
    QString wanted;
    for (const auto make : espalier::test::TestClasses::all()) {
        if (nameOf(*make()) == first)
            wanted = arguments.takeAt(1);
    }
    int failures = 0;
    for (const auto make : espalier::test::TestClasses::all()) {
        const std::unique_ptr<QObject> test = make();
        if (wanted.isEmpty() || nameOf(*test) == wanted)
            failures += QTest::qExec(test.get(), arguments);
    }
    return failures;
}
