// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/DrawingFile.h"

#include "model/io/FileReader.h"
#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include <algorithm>

namespace espalier {

namespace {

struct DrawingText {
    Q_DECLARE_TR_FUNCTIONS(Drawing)
};

constexpr qint64 kMostDrawingBytes = qint64{32} << 20;
/// The longer side of an SVG while its curves are made lines, so that these are fine.
constexpr double kSvgSize = 2000.0;
/// Of an SVG, when its curves are lines.
constexpr std::size_t kMostDrawingPoints = 2'000'000;

/// Keeps the lines that are painted.
class LineRecorder : public QPaintEngine {
public:
    LineRecorder() : QPaintEngine(AllFeatures) {}

    DrawingStrokes strokes;
    bool isTooLarge() const { return m_points > kMostDrawingPoints; }

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& changed) override
    {
        if (changed.state().testFlag(DirtyTransform))
            m_transform = changed.transform();
    }
    void drawPath(const QPainterPath& path) override
    {
        for (const QPolygonF& polygon : path.toSubpathPolygons(m_transform))
            add(polygon);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override
    {
        QPolygonF polygon(QList<QPointF>(points, points + count));
        if (mode != PolylineMode && !polygon.isEmpty())
            polygon.append(polygon.constFirst());
        add(m_transform.map(polygon));
    }
    void drawLines(const QLineF* lines, int count) override
    {
        for (int i = 0; i < count; ++i)
            add(m_transform.map(QPolygonF({lines[i].p1(), lines[i].p2()})));
    }
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
    void drawTextItem(const QPointF&, const QTextItem&) override {}

private:
    void add(const QPolygonF& polygon)
    {
        m_points += static_cast<std::size_t>(polygon.size());
        if (m_points > kMostDrawingPoints)
            return; // isTooLarge()
        std::vector<Vec2> stroke;
        for (const QPointF& point : polygon)
            stroke.emplace_back(static_cast<float>(point.x()), static_cast<float>(-point.y()));
        // What is both filled and stroked may be painted twice.
        if (!stroke.empty() && (strokes.empty() || strokes.back() != stroke))
            strokes.push_back(std::move(stroke));
    }

    QTransform m_transform;
    std::size_t m_points = 0;
};

class LineDevice : public QPaintDevice {
public:
    LineDevice(QSize size, LineRecorder& recorder) : m_size(size), m_recorder(recorder) {}
    QPaintEngine* paintEngine() const override { return &m_recorder; }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmNumColors:
            return 1 << 24;
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        default:
            return 96; // Dots per inch, and sizes in mm, which nothing asks for
        }
    }

private:
    QSize m_size;
    LineRecorder& m_recorder;
};

/// The SVG without its texts, which would be painted as outlines of letters.
QByteArray withoutTexts(const QByteArray& svg)
{
    QByteArray kept;
    QXmlStreamReader reader(svg);
    QXmlStreamWriter writer(&kept);
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QLatin1StringView("text"))
            reader.skipCurrentElement();
        else if (reader.tokenType() != QXmlStreamReader::Invalid &&
                 reader.tokenType() != QXmlStreamReader::DTD)
            writer.writeCurrentToken(reader);
    }
    return reader.hasError() ? svg : kept;
}

Result<DrawingStrokes> readSvg(const QByteArray& bytes)
{
    QSvgRenderer renderer(withoutTexts(bytes));
    if (!renderer.isValid())
        return Error{Error::Kind::Input, DrawingText::tr("it is not an SVG")};
    const QRectF box = renderer.viewBoxF();
    const double longer = std::max(box.width(), box.height());
    if (!(longer > 0.0))
        return Error{Error::Kind::Input, DrawingText::tr("it is not an SVG")};
    const QSize size(std::max(1, static_cast<int>(kSvgSize * box.width() / longer)),
                     std::max(1, static_cast<int>(kSvgSize * box.height() / longer)));
    LineRecorder recorder;
    LineDevice device(size, recorder);
    QPainter painter(&device);
    renderer.render(&painter, QRectF(QPointF(), size));
    painter.end();
    if (recorder.isTooLarge())
        return Error{Error::Kind::Input,
                     DrawingText::tr("it has more than %1 points").arg(kMostDrawingPoints)};
    return std::move(recorder.strokes);
}

Result<DrawingStrokes> readQuickDraw(const QByteArray& bytes, int index)
{
    QByteArray line;
    qsizetype from = 0;
    for (int i = 0; i <= index; ++i) {
        if (from >= bytes.size())
            return Error{Error::Kind::Input, DrawingText::tr("it has no drawing %1").arg(index)};
        const qsizetype end = bytes.indexOf('\n', from);
        line = bytes.mid(from, end < 0 ? -1 : end - from);
        from = end < 0 ? bytes.size() : end + 1;
    }
    const Result<QJsonObject> json = parseJsonObject(line, kMostDrawingBytes);
    if (!json)
        return json.error();
    DrawingStrokes strokes;
    for (const QJsonValue drawn : json->value(QLatin1StringView("drawing")).toArray()) {
        const QJsonArray right = drawn.toArray().at(0).toArray();
        const QJsonArray down = drawn.toArray().at(1).toArray();
        if (right.size() != down.size())
            return Error{Error::Kind::Input, DrawingText::tr("a stroke has more x than y values, or fewer")};
        std::vector<Vec2> stroke;
        for (qsizetype i = 0; i < right.size(); ++i) {
            const Vec2 point(static_cast<float>(right.at(i).toDouble()),
                             static_cast<float>(-down.at(i).toDouble()));
            if (!point.allFinite() || !right.at(i).isDouble() || !down.at(i).isDouble())
                return Error{Error::Kind::Input,
                             DrawingText::tr("a stroke has a point that is not a number")};
            stroke.push_back(point);
        }
        if (!stroke.empty())
            strokes.push_back(std::move(stroke));
    }
    return strokes;
}

} // namespace

Result<DrawingStrokes> readDrawing(const QString& fileName, int index)
{
    const QString name = QFileInfo(fileName).fileName();
    const Result<QByteArray> bytes = readFile(fileName, kMostDrawingBytes, FileKind::Any);
    if (!bytes)
        return bytes.error();
    const bool isSvg = QFileInfo(fileName).suffix().toLower() == QLatin1String("svg");
    Result<DrawingStrokes> strokes = parseDrawing(*bytes, isSvg, index);
    return strokes ? std::move(strokes) : inputError(name, strokes.error().message);
}

Result<DrawingStrokes> parseDrawing(const QByteArray& bytes, bool isSvg, int index)
{
    Result<DrawingStrokes> strokes = isSvg ? readSvg(bytes) : readQuickDraw(bytes, index);
    if (strokes && strokes->empty())
        return Error{Error::Kind::Input, DrawingText::tr("it has no strokes")};
    return strokes;
}

DrawingStrokes fittedDrawing(DrawingStrokes strokes)
{
    Eigen::AlignedBox2f box;
    for (const std::vector<Vec2>& stroke : strokes) {
        for (const Vec2& point : stroke)
            box.extend(point);
    }
    if (box.isEmpty())
        return strokes;
    const float size = box.sizes().y() > 0.0F ? box.sizes().y() : std::max(box.sizes().x(), 1.0F);
    const float scale = static_cast<float>(kDrawingHeight) / size;
    const Vec2 foot(box.center().x(), box.min().y());
    for (std::vector<Vec2>& stroke : strokes) {
        for (Vec2& point : stroke)
            point = scale * (point - foot);
    }
    return strokes;
}

} // namespace espalier
