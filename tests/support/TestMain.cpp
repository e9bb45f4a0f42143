// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"

#include <QtTest>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
using Application = QApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

/// Runs every test class. If the first argument is the name of a class, runs only that class, with the other
/// arguments.
int main(int argc, char** argv)
{
    const Application application(argc, argv);
    QStringList arguments = QCoreApplication::arguments();
    QString wanted;
    for (const auto make : espalier::test::TestClasses::all()) {
        const QString name =
            QString::fromLatin1(make()->metaObject()->className()).section(QLatin1String("::"), -1);
        if (arguments.size() > 1 && arguments[1] == name)
            wanted = arguments.takeAt(1);
    }

    int failures = 0;
    for (const auto make : espalier::test::TestClasses::all()) {
        const std::unique_ptr<QObject> test = make();
        const QString name =
            QString::fromLatin1(test->metaObject()->className()).section(QLatin1String("::"), -1);
        if (wanted.isEmpty() || wanted == name)
            failures += QTest::qExec(test.get(), arguments);
    }
    return failures;
}
