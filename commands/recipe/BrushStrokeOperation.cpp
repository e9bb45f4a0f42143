// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/BrushStrokeOperation.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kSamplesKey("samples");

/// What is wrong with the sample, or nothing; then @p sample is the one that @p value says.
std::optional<QString> readSample(const QJsonValue& value, double previousTime, BrushSample& sample)
{
    const QJsonArray array = value.toArray();
    std::array<double, 5> numbers{};
    bool good = array.size() == 5;
    for (qsizetype i = 0; good && i < 5; ++i) {
        good = array.at(i).isDouble();
        numbers[static_cast<std::size_t>(i)] = array.at(i).toDouble();
    }
    if (!good)
        return RecipeText::tr("an array of five numbers is expected: time, x, y, z, radius");
    const auto& [time, x, y, z, radius] = numbers;
    if (!(time >= 0.0 && time <= BrushStrokeOperation::kGreatestTime))
        return RecipeText::tr("the time is not within 0…%1 s").arg(BrushStrokeOperation::kGreatestTime);
    if (time <= previousTime)
        return RecipeText::tr("the time does not go forwards");
    for (const double coordinate : {x, y, z}) {
        if (!(std::abs(coordinate) <= recipeLimits::kCoordinate))
            return RecipeText::tr("a coordinate is not within ±%1 m").arg(recipeLimits::kCoordinate);
    }
    if (!(radius >= 0.0 && radius <= BrushStrokeOperation::kGreatestRadius))
        return RecipeText::tr("the radius is not within 0…%1 m").arg(BrushStrokeOperation::kGreatestRadius);
    sample = {time, Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)),
              static_cast<float>(radius)};
    return {};
}

/// A stroke that takes its own time.
class StrokePerformance : public Performance {
public:
    StrokePerformance(TreeDocument& document, const BrushStrokeOperation& operation, BudReference::Found only)
        : m_document(document),
          m_samples(operation.samples),
          m_warning(std::move(only.warning)),
          m_historyBefore(document.journal().size()),
          m_gesture(document, m_samples.front(), only.competitors),
          m_time(m_samples.front().time)
    {
    }

    bool advance(double seconds) override
    {
        m_time += seconds;
        for (; m_next < m_samples.size() && m_samples[m_next].time <= m_time; ++m_next)
            m_gesture.add(m_samples[m_next]);
        if (m_next < m_samples.size()) {
            m_gesture.moveToward(m_samples[m_next], m_time);
            return false;
        }
        if (m_warning.isEmpty() && m_document.journal().size() == m_historyBefore)
            m_warning = RecipeText::tr("nothing grew");
        m_gesture.finish();
        return true;
    }
    QString warning() const override { return m_warning; }
    const BrushGesture* stroke() const override { return &m_gesture; }

private:
    const TreeDocument& m_document;
    std::span<const BrushSample> m_samples;
    QString m_warning;
    std::size_t m_historyBefore;
    BrushGesture m_gesture;
    double m_time; ///< s of the stroke
    std::size_t m_next = 1;
};

} // namespace

BrushStrokeOperation BrushStrokeOperation::read(JsonReader& reader, RecipeReading& reading)
{
    const QJsonArray array = reader.array(kSamplesKey);
    BrushStrokeOperation stroke;
    stroke.only = BudReference::read(reader);
    if (array.isEmpty())
        reader.fail(kSamplesKey, RecipeText::tr("a stroke has at least one sample"));
    if (!reading.admitSamples(reader, kSamplesKey, array.size()))
        return stroke;
    stroke.samples.resize(static_cast<std::size_t>(array.size()));
    double time = -1.0;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        if (const auto fault = readSample(array.at(static_cast<qsizetype>(i)), time, stroke.samples[i])) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kSamplesKey)).arg(i), *fault));
            break;
        }
        time = stroke.samples[i].time;
    }
    return stroke;
}

QJsonObject BrushStrokeOperation::write(RecipeWriting&) const
{
    QJsonArray array;
    for (const BrushSample& sample : samples) {
        array.append(QJsonArray{sample.time, shortestDouble(sample.position.x()),
                                shortestDouble(sample.position.y()), shortestDouble(sample.position.z()),
                                shortestDouble(sample.radius)});
    }
    QJsonObject json{{kSamplesKey, array}};
    only.write(json);
    return json;
}

std::unique_ptr<Performance> BrushStrokeOperation::begin(TreeDocument& document) const
{
    return std::make_unique<StrokePerformance>(document, *this, only.resolve(document));
}

Box3 BrushStrokeOperation::reach() const
{
    Box3 box;
    for (const BrushSample& sample : samples) {
        const Vec3 radius = Vec3::Constant(sample.radius);
        box.extend(Box3(sample.position - radius, sample.position + radius));
    }
    return box;
}

} // namespace espalier
