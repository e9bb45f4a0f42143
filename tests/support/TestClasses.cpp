// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>

namespace espalier::test {

namespace {

/// Without namespaces.
QString nameOf(const QObject& test)
{
    return QString::fromLatin1(test.metaObject()->className()).section(QLatin1String("::"), -1);
}

} // namespace

std::vector<TestClasses::Make>& TestClasses::all()
{
    static std::vector<Make> classes;
    return classes;
}

int TestClasses::run(QStringList arguments)
{
    QStringList known;
    for (const Make make : all())
        known.push_back(nameOf(*make()));
    known.sort();
    QStringList wanted;
    while (arguments.size() > 1 && known.contains(arguments[1]))
        wanted.push_back(arguments.takeAt(1));

    int failures = 0;
    for (const Make make : all()) {
        const std::unique_ptr<QObject> test = make();
        if (wanted.isEmpty() || wanted.contains(nameOf(*test)))
            failures += QTest::qExec(test.get(), arguments);
    }
    return std::min(failures, 100); // an exit status of 256 would count as success
}

} // namespace espalier::test
