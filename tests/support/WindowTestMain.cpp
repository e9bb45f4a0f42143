// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Memory.h"
#include "panels/Theme.h"
#include "tests/support/TestClasses.h"
#include "views/render/GlResources.h"

#include <QApplication>
#include <QSurfaceFormat>

/// Runs tests in an application with the program's style and with separate settings.
int main(int argc, char** argv)
{
    espalier::keepFreedMemory();
    QSurfaceFormat::setDefaultFormat(espalier::surfaceFormat());
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-test"));
    espalier::theme::apply(application);
    return espalier::test::TestClasses::run(QCoreApplication::arguments());
}
