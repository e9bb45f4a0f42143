// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxRepair.h"

#include "tests/support/TestClasses.h"

#include <QBuffer>
#include <QTest>
#include <QtEndian>

#include <functional>

namespace espalier::test {

namespace {

/// Makes FBX files by hand.
struct FbxBuilder {
    bool wide = true;
    bool withRecords = true; ///< The records of zeros that end nested lists
    QByteArray content;

    explicit FbxBuilder(bool isWide, bool records) : wide(isWide), withRecords(records)
    {
        content = QByteArray("Kaydara FBX Binary  \0\x1a\0", 23);
        appendLittle<std::uint32_t>(wide ? 7500 : 7400);
    }
    template <class T>
    void appendLittle(T value)
    {
        char bytes[sizeof(T)];
        qToLittleEndian(value, bytes);
        content.append(bytes, sizeof(T));
    }
    void appendNumber(qsizetype value)
    {
        if (wide)
            appendLittle(static_cast<std::uint64_t>(value));
        else
            appendLittle(static_cast<std::uint32_t>(value));
    }
    void appendNull() { content.append(wide ? 25 : 13, '\0'); }

    void node(const QByteArray& name, const QByteArray& properties, const std::function<void()>& nested = {})
    {
        const qsizetype begin = content.size();
        appendNumber(0);
        appendNumber(properties.isEmpty() ? 0 : 1);
        appendNumber(properties.size());
        content.append(static_cast<char>(name.size()));
        content.append(name + properties);
        if (nested) {
            nested();
            if (withRecords)
                appendNull();
        }
        const QByteArray rest = content.sliced(begin);
        const qsizetype end = content.size();
        content.truncate(begin);
        appendNumber(end);
        content.append(rest.sliced(wide ? 8 : 4));
    }
    /// What every file ends with.
    void finish()
    {
        appendNull();
        content.append(QByteArray::fromHex("fabcab09d0c8d466b176fb831cf7267e"));
        content.append(16 - content.size() % 16, '\0');
        content.append(4, '\0');
        appendLittle<std::uint32_t>(wide ? 7500 : 7400);
        content.append(120, '\0');
        content.append(QByteArray::fromHex("f85a8c6adef5d97eece90ce3758f290b"));
    }
};

QByteArray file(bool wide, bool records)
{
    FbxBuilder fbx(wide, records);
    fbx.node("FBXHeaderExtension", "", [&] {
        fbx.node("FBXHeaderVersion", "I1234");
        fbx.node("SceneInfo", "Sxx",
                 [&] { fbx.node("MetaData", "", [&] { fbx.node("Version", "I5678"); }); });
        fbx.node("Creator", "Sespalier");
    });
    fbx.node("References", "");
    fbx.node("Objects", "",
             [&] { fbx.node("Geometry", QByteArray(1000, 'x'), [&] { fbx.node("V", "I0000"); }); });
    fbx.finish();
    return fbx.content;
}

/// The bytes of the repaired file.
QByteArray repaired(const QByteArray& content)
{
    const Result<FbxDocument> document = repairFbx(content);
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    return document && writeFbx(*document, bytes) ? bytes.data() : QByteArray();
}

} // namespace

class FbxRepairTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void missingRecords_arePutIn_data();
    void missingRecords_arePutIn();
    void soundFile_staysTheSame_data();
    void soundFile_staysTheSame();
    void otherContent_isRefused();
    void truncatedFile_isRefusedWhereverItEnds();
    void endlessNesting_isRefused();
    void wrongOffsets_areRefused();
};

void FbxRepairTest::missingRecords_arePutIn_data()
{
    QTest::addColumn<bool>("wide");
    QTest::newRow("64 bits") << true;
    QTest::newRow("32 bits") << false;
}

void FbxRepairTest::missingRecords_arePutIn()
{
    QFETCH(bool, wide);
    QVERIFY(file(wide, false) != file(wide, true));
    QCOMPARE(repaired(file(wide, false)), file(wide, true));
}

void FbxRepairTest::soundFile_staysTheSame_data()
{
    missingRecords_arePutIn_data();
}

void FbxRepairTest::soundFile_staysTheSame()
{
    QFETCH(bool, wide);
    QCOMPARE(repaired(file(wide, true)), file(wide, true));
}

void FbxRepairTest::otherContent_isRefused()
{
    QVERIFY(!repairFbx({}));
    QVERIFY(!repairFbx(QByteArray("; FBX 7.5.0 project file")));
    QVERIFY(!repairFbx(QByteArray(1000, '\0')));
}

void FbxRepairTest::truncatedFile_isRefusedWhereverItEnds()
{
    const QByteArray whole = file(true, false);
    const qsizetype nodesEnd = whole.lastIndexOf(QByteArray::fromHex("fabcab09"));
    for (qsizetype size = 0; size < nodesEnd; ++size)
        QVERIFY(!repairFbx(whole.first(size)));
    for (qsizetype size = nodesEnd; size < whole.size(); ++size)
        QVERIFY(repairFbx(whole.first(size)));
}

void FbxRepairTest::endlessNesting_isRefused()
{
    FbxBuilder fbx(true, false);
    const std::function<void(int)> nest = [&](int depth) {
        fbx.node("N", "", depth > 0 ? std::function<void()>([&, depth] { nest(depth - 1); }) : nullptr);
    };
    nest(60);
    fbx.finish();
    QVERIFY(repairFbx(fbx.content));
    FbxBuilder deep(true, false);
    const std::function<void(int)> nestDeep = [&](int depth) {
        deep.node("N", "", depth > 0 ? std::function<void()>([&, depth] { nestDeep(depth - 1); }) : nullptr);
    };
    nestDeep(100);
    deep.finish();
    QVERIFY(!repairFbx(deep.content));
}

void FbxRepairTest::wrongOffsets_areRefused()
{
    const QByteArray whole = file(true, false);
    // The first node's end, number of properties and their size.
    for (const std::uint64_t wrong :
         {std::uint64_t{1}, std::uint64_t{52}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
        for (const qsizetype field : {27, 27 + 16}) {
            QByteArray changed = whole;
            qToLittleEndian(wrong, changed.data() + field);
            if (changed != whole)
                QVERIFY(!repairFbx(changed));
        }
    }
}

static const TestClass<FbxRepairTest> fbxRepairTest;

} // namespace espalier::test

#include "FbxRepairTest.moc"
