// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/StampedColumn.h"

#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class StampedColumnTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void entries_countUntilTheNextClear();
    void oldEntries_neverCountAgain();
    void column_growsWithItsSize();
};

void StampedColumnTest::entries_countUntilTheNextClear()
{
    StampedColumn<int> column;
    column.clear(3);
    QVERIFY(!column.has(1));
    QVERIFY(column.setOnce(1, 5));
    QVERIFY(!column.setOnce(1, 6));
    QCOMPARE(column[1], 5);
    column.set(1, 7);
    QCOMPARE(column[1], 7);
    QVERIFY(!column.has(0) && !column.has(2));
    column.clear(3);
    QVERIFY(!column.has(1));
}

void StampedColumnTest::oldEntries_neverCountAgain()
{
    // Stamps are counted modulo 256.
    for (int age = 1; age < 600; ++age) {
        StampedColumn<int> column;
        column.clear(2);
        column.set(0, 1);
        for (int i = 0; i < age; ++i)
            column.clear(2);
        QVERIFY2(!column.has(0) && !column.has(1), qPrintable(QString::number(age)));
        column.set(1, 2);
        QVERIFY(column.has(1));
    }
}

void StampedColumnTest::column_growsWithItsSize()
{
    StampedColumn<int> column;
    for (std::uint32_t size = 1; size < 3'000; size += 97) {
        column.clear(size);
        for (InternodeId id = 0; id < size; ++id)
            QVERIFY(!column.has(id));
        column.set(size - 1, 1);
        QVERIFY(column.has(size - 1));
    }
}

const TestClass<StampedColumnTest> stampedColumnTest;

} // namespace espalier::test

#include "StampedColumnTest.moc"
