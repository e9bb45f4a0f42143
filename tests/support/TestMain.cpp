// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"

#include <QGuiApplication>

/// Runs the tests that need no widget.
int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    return espalier::test::TestClasses::run(QCoreApplication::arguments());
}
