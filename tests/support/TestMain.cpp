// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Memory.h"
#include "tests/support/TestClasses.h"

#include <QGuiApplication>

/// Runs the tests that need no widget.
int main(int argc, char** argv)
{
    espalier::keepFreedMemory();
    const QGuiApplication application(argc, argv);
    return espalier::test::TestClasses::run(QCoreApplication::arguments());
}
