// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <memory>
#include <vector>

namespace espalier::test {

/// The test classes of a test program, in one file each.
struct TestClasses {
    using Make = std::unique_ptr<QObject> (*)();
    static std::vector<Make>& all();
    /// Runs the classes whose names come first in @p arguments (after the program's name), or all if there
    /// are none, with the other arguments. Returns the number of failures.
    static int run(QStringList arguments);
};

/// A static object of this type registers a class: "static const TestClass<WidthsTest> widthsTest;".
template <class Test>
struct TestClass {
    TestClass()
    {
        TestClasses::all().push_back([]() -> std::unique_ptr<QObject> { return std::make_unique<Test>(); });
    }
};

} // namespace espalier::test
