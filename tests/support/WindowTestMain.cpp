// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Theme.h"
#include "tests/support/TestClasses.h"
#include "views/render/GlResources.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QtTest>

/// Runs every test class in an application that looks like the program and has settings of its own.
int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(espalier::surfaceFormat());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-test"));
    espalier::theme::apply(application);
    int failures = 0;
    for (const auto make : espalier::test::TestClasses::all())
        failures += QTest::qExec(make().get(), argc, argv);
    return failures;
}
