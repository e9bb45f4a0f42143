// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/DrawingFile.h"

#include "tests/support/TestClasses.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

class DrawingFileTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void svg_linesAreStrokesInTheirOrder();
    void svg_transformsAndCurvesAreFollowed();
    void svg_textsAndImagesAreLeftOut();
    void quickDraw_takesTheLineThatIsAskedFor();
    void faults_areNamed_data();
    void faults_areNamed();
    void fitted_standsOnTheGround();

private:
    QString fileOf(const QByteArray& content, const QString& name);
    QTemporaryDir m_folder;
};

QString DrawingFileTest::fileOf(const QByteArray& content, const QString& name)
{
    const QString path = m_folder.filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("%s cannot be written", qPrintable(path));
    return path;
}

void DrawingFileTest::svg_linesAreStrokesInTheirOrder()
{
    const QString path = fileOf(R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 200">
        <polyline points="50,200 52,100 50,20" fill="none" stroke="black"/>
        <line x1="50" y1="120" x2="90" y2="60" stroke="black"/>
        <path d="M50 100 L10 70" fill="none" stroke="black"/></svg>)svg",
                                QStringLiteral("lines.svg"));
    const Result<DrawingStrokes> strokes = readDrawing(path, 0);
    QVERIFY2(strokes, strokes ? "" : qPrintable(strokes.error().message));
    QCOMPARE(strokes->size(), 3U);
    QCOMPARE((*strokes)[0].size(), 3U);
    // 200 units high are 2,000; y runs up.
    QVERIFY(((*strokes)[0].front() - Vec2(500.0F, -2000.0F)).norm() < 1.0F);
    QVERIFY(((*strokes)[1].back() - Vec2(900.0F, -600.0F)).norm() < 1.0F);
    QVERIFY(((*strokes)[2].back() - Vec2(100.0F, -700.0F)).norm() < 1.0F);
}

void DrawingFileTest::svg_transformsAndCurvesAreFollowed()
{
    const QString path = fileOf(R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 200">
        <g transform="translate(100 100) rotate(90)"><path d="m0 0 q 40 0 40 40" fill="none" stroke="black"/></g>
        <circle cx="100" cy="50" r="20" fill="green" stroke="black"/></svg>)svg",
                                QStringLiteral("curves.svg"));
    const Result<DrawingStrokes> strokes = readDrawing(path, 0);
    QVERIFY(strokes);
    QCOMPARE(strokes->size(), 2U);
    const std::vector<Vec2>& curve = strokes->front();
    QVERIFY(curve.size() > 6);
    QVERIFY((curve.front() - Vec2(1000.0F, -1000.0F)).norm() < 1.0F);
    // (40, 40) turned by 90° is (-40, 40).
    QVERIFY((curve.back() - Vec2(600.0F, -1400.0F)).norm() < 1.0F);
    const std::vector<Vec2>& circle = strokes->back();
    QVERIFY((circle.front() - circle.back()).norm() < 1.0F);
    for (const Vec2& point : circle)
        QVERIFY(std::abs((point - Vec2(1000.0F, -500.0F)).norm() - 200.0F) < 4.0F);
}

void DrawingFileTest::svg_textsAndImagesAreLeftOut()
{
    const QString path = fileOf(R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
        <text x="10" y="10">A tree</text><line x1="0" y1="0" x2="90" y2="60" stroke="black"/></svg>)svg",
                                QStringLiteral("text.svg"));
    const Result<DrawingStrokes> strokes = readDrawing(path, 0);
    QVERIFY(strokes);
    QCOMPARE(strokes->size(), 1U);
}

void DrawingFileTest::quickDraw_takesTheLineThatIsAskedFor()
{
    const QString path = fileOf(R"({"word":"tree","drawing":[[[0,1],[5,6]]]}
{"word":"tree","drawing":[[[10,20,30],[0,5,10]],[[7],[8]]]}
)",
                                QStringLiteral("two.ndjson"));
    const Result<DrawingStrokes> strokes = readDrawing(path, 1);
    QVERIFY(strokes);
    QCOMPARE(strokes->size(), 2U);
    QCOMPARE((*strokes)[0].back(), Vec2(30.0F, -10.0F));
    const Result<DrawingStrokes> none = readDrawing(path, 2);
    QVERIFY(!none);
    QCOMPARE(none.error().message, QStringLiteral("two.ndjson: it has no drawing 2"));
}

void DrawingFileTest::faults_areNamed_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("fault");
    QTest::newRow("no SVG") << QByteArray("hello") << "a.svg"
                            << "a.svg: it is not an SVG";
    QTest::newRow("empty SVG")
        << QByteArray(R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"></svg>)svg") << "b.svg"
        << "b.svg: it has no strokes";
    QTest::newRow("no JSON") << QByteArray("hello") << "c.ndjson"
                             << "c.ndjson: ";
    QTest::newRow("uneven") << QByteArray(R"({"drawing":[[[1,2],[1]]]})") << "d.ndjson"
                            << "d.ndjson: a stroke has more x than y values, or fewer";
    QTest::newRow("no number") << QByteArray(R"({"drawing":[[[1,"a"],[1,2]]]})") << "e.ndjson"
                               << "e.ndjson: a stroke has a point that is not a number";
    QTest::newRow("no strokes") << QByteArray(R"({"drawing":[]})") << "f.ndjson"
                                << "f.ndjson: it has no strokes";
}

void DrawingFileTest::faults_areNamed()
{
    QFETCH(const QByteArray, content);
    QFETCH(const QString, name);
    QFETCH(const QString, fault);
    const Result<DrawingStrokes> strokes = readDrawing(fileOf(content, name), 0);
    QVERIFY(!strokes);
    QVERIFY2(strokes.error().message.startsWith(fault), qPrintable(strokes.error().message));
}

void DrawingFileTest::fitted_standsOnTheGround()
{
    const DrawingStrokes fitted = fittedDrawing({{Vec2(10.0F, -200.0F), Vec2(30.0F, -100.0F)}});
    QVERIFY((fitted.front().front() - Vec2(-0.3F, 0.0F)).norm() < 1e-5F);
    QVERIFY((fitted.front().back() - Vec2(0.3F, 3.0F)).norm() < 1e-5F);
    QVERIFY(fittedDrawing({}).empty());
}

static const TestClass<DrawingFileTest> drawingFileTest;

} // namespace espalier::test

#include "DrawingFileTest.moc"
