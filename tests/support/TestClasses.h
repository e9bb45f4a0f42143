// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <memory>
#include <vector>

namespace espalier::test {

/// The test classes of an executable that has several of them, in one file each; TestMain.cpp runs them all.
struct TestClasses {
    using Make = std::unique_ptr<QObject> (*)();
    static std::vector<Make>& all()
    {
        static std::vector<Make> classes;
        return classes;
    }
};

/// A static object of this type enters a class: "const TestClass<WidthsTest> entered;".
template <class Test>
struct TestClass {
    TestClass()
    {
        TestClasses::all().push_back([]() -> std::unique_ptr<QObject> { return std::make_unique<Test>(); });
    }
};

} // namespace espalier::test
