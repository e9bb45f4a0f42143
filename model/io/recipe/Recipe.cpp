// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/recipe/Recipe.h"

#include "model/io/ImageFile.h"
#include "model/io/JsonReader.h"
#include "model/io/ParametersJson.h"
#include "model/texture/OwnTextures.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>

#include <cmath>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Recipe)
};

constexpr QLatin1StringView kParametersKey("parameters");
constexpr QLatin1StringView kSamplesKey("samples");
constexpr QLatin1StringView kPointsKey("points");
constexpr QLatin1StringView kViews[] = {QLatin1StringView("front"), QLatin1StringView("side"),
                                        QLatin1StringView("top"), QLatin1StringView("three-quarter")};

/// The numbers of an array, or nothing if it does not hold so many, each within ±@p limit.
template <int Count>
std::optional<Eigen::Matrix<float, Count, 1>> numbers(const QJsonArray& array, double limit)
{
    Eigen::Matrix<float, Count, 1> result;
    for (int i = 0; i < Count; ++i) {
        if (array.size() != Count || !array.at(i).isDouble() || !(std::abs(array.at(i).toDouble()) <= limit))
            return {};
        result[i] = static_cast<float>(array.at(i).toDouble());
    }
    return result;
}

/// All buds, or the one that "only" names.
Competitors parseCompetitors(JsonReader& parent)
{
    const QLatin1StringView key("only");
    if (!parent.has(key))
        return {};
    JsonReader reader(parent.object(key), parent.placeOf(key));
    Competitors competitors;
    competitors.node =
        static_cast<InternodeId>(reader.integer(QLatin1StringView("internode"), 0, kNoInternode - 1));
    competitors.slot =
        static_cast<int>(reader.integer(QLatin1StringView("bud"), 0, kTerminalSlot, kTerminalSlot));
    if (competitors.slot >= kMaxLaterals && competitors.slot != kTerminalSlot)
        reader.fail(QLatin1StringView("bud"), Text::tr("there is no such bud"));
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
    return competitors;
}

/// Reads parameters, and the images that they name, each file once.
class ParametersParser {
public:
    explicit ParametersParser(const QString& folder) : m_folder(folder) {}

    /// @p base with what @p json says.
    Result<TreeParameters> parse(const QJsonObject& json, TreeParameters base, const QString& place);

private:
    struct Image {
        Result<ImageAsset> asset;
        double aspect = 1.0; ///< As a leaf; 0 if there is none in it
    };

    const Image& image(const QString& name);
    Result<ImageAsset> read(const QString& name) const;

    QString m_folder;
    QHash<QString, Image> m_images;
};

Result<ImageAsset> ParametersParser::read(const QString& name) const
{
    if (m_folder.isEmpty())
        return inputError(name, Text::tr("a recipe that is no file has no images"));
    if (m_images.size() >= recipeLimits::kImages)
        return inputError(name, Text::tr("a recipe has at most %1 images").arg(recipeLimits::kImages));
    if (QDir::isAbsolutePath(name))
        return inputError(name, Text::tr("a path relative to the recipe is expected"));
    return readImageFile(QDir(m_folder).filePath(name), name);
}

const ParametersParser::Image& ParametersParser::image(const QString& name)
{
    const auto known = m_images.find(name);
    if (known != m_images.end())
        return *known;
    Image image{read(name)};
    if (image.asset)
        image.aspect = ownLeafAspect(*image.asset).value_or(0.0);
    return *m_images.insert(name, image);
}

Result<TreeParameters> ParametersParser::parse(const QJsonObject& json, TreeParameters base,
                                               const QString& place)
{
    const ImageOfName imageOfName = [this](const QString& name) { return image(name).asset; };
    const QString leaf =
        json.value(QLatin1String("leaves")).toObject().value(QLatin1String("image")).toString();
    if (!leaf.isEmpty()) {
        const Image& found = image(leaf);
        if (found.asset && found.aspect == 0.0)
            return inputError(place + QLatin1String(".leaves.image"), noLeafIn(*found.asset));
        if (found.asset && !(base.leaves.image == *found.asset))
            adoptImage(base.leaves, *found.asset, found.aspect);
    }
    return fromJson(json, base, place, imageOfName);
}

/// Reads the operations in turn; each may lean on those before.
class OperationsParser {
public:
    OperationsParser(const TreeParameters& parameters, ParametersParser& parser)
        : m_parameters(parameters), m_parser(parser)
    {
    }

    Result<RecipeOperation> parse(const QJsonValue& value, const QString& place);

private:
    Result<RecipeOperation> parseParameters(JsonReader& reader);
    RecipeOperation parseStroke(JsonReader& reader);
    RecipeOperation parseLasso(JsonReader& reader);
    bool admit(JsonReader& reader, QLatin1StringView key, qsizetype samples);
    RecipeOperation parsePrune(JsonReader& reader);
    static RecipeOperation parseBend(JsonReader& reader);
    static RecipeOperation parseWidth(JsonReader& reader);
    std::optional<QString> parseSample(const QJsonValue& value, double previousTime,
                                       BrushSample& sample) const;

    TreeParameters m_parameters; ///< In force
    ParametersParser& m_parser;
    qsizetype m_samples = 0;
};

Result<RecipeOperation> OperationsParser::parse(const QJsonValue& value, const QString& place)
{
    if (!value.isObject())
        return inputError(place, Text::tr("an object is expected"));
    JsonReader reader(value.toObject(), place);
    const QString op = reader.text(QLatin1StringView("op"));
    Result<RecipeOperation> operation = RecipeOperation{};
    if (op == QLatin1StringView("setParameters")) {
        operation = parseParameters(reader);
    } else if (op == QLatin1StringView("brushStroke")) {
        operation = parseStroke(reader);
    } else if (op == QLatin1StringView("grow")) {
        const auto steps = reader.integer(QLatin1StringView("steps"), 1, recipeLimits::kGrowSteps);
        operation = RecipeOperation(GrowOperation{static_cast<int>(steps), parseCompetitors(reader)});
    } else if (op == QLatin1StringView("travel")) {
        const auto by =
            reader.integer(QLatin1StringView("by"), -recipeLimits::kTravel, recipeLimits::kTravel);
        if (by == 0)
            reader.fail(QLatin1StringView("by"), Text::tr("a number other than 0 is expected"));
        operation = RecipeOperation(TravelOperation{static_cast<int>(by)});
    } else if (op == QLatin1StringView("prune")) {
        operation = parsePrune(reader);
    } else if (op == QLatin1StringView("undo") || op == QLatin1StringView("redo")) {
        const auto count = reader.integer(QLatin1StringView("count"), 1, recipeLimits::kUndoCount, 1);
        operation = op == QLatin1StringView("undo") ? RecipeOperation(UndoOperation{static_cast<int>(count)})
                                                    : RecipeOperation(RedoOperation{static_cast<int>(count)});
    } else if (op == QLatin1StringView("bend")) {
        operation = parseBend(reader);
    } else if (op == QLatin1StringView("setWidth")) {
        operation = parseWidth(reader);
    } else if (op == QLatin1StringView("lasso")) {
        operation = parseLasso(reader);
    } else if (op == QLatin1StringView("regrow")) {
        operation = RecipeOperation(RegrowOperation{});
    } else if (op == QLatin1StringView("removeLasso")) {
        operation = RecipeOperation(RemoveLassoOperation{});
    } else {
        reader.fail(QLatin1StringView("op"),
                    Text::tr("there is no operation “%1”; there are setParameters, brushStroke, grow, prune, "
                             "travel, undo, redo, bend, setWidth, lasso, regrow and removeLasso")
                        .arg(op));
    }
    if (!operation)
        return operation;
    if (const Result<void> end = reader.finish(); !end)
        return end.error();
    return operation;
}

Result<RecipeOperation> OperationsParser::parseParameters(JsonReader& reader)
{
    if (!reader.has(kParametersKey))
        reader.fail(kParametersKey, Text::tr("it is missing"));
    Result<TreeParameters> parameters =
        m_parser.parse(reader.object(kParametersKey), m_parameters, reader.placeOf(kParametersKey));
    if (!parameters)
        return parameters.error();
    normaliseDirectionWeights(parameters->growth);
    m_parameters = *parameters;
    return RecipeOperation(SetParametersOperation{m_parameters});
}

RecipeOperation OperationsParser::parseStroke(JsonReader& reader)
{
    const QJsonArray array = reader.array(kSamplesKey);
    const QString place = reader.placeOf(kSamplesKey);
    BrushStrokeOperation stroke;
    stroke.competitors = parseCompetitors(reader);
    if (array.isEmpty())
        reader.fail(kSamplesKey, Text::tr("a stroke has at least one sample"));
    if (!admit(reader, kSamplesKey, array.size()))
        return stroke;
    stroke.samples.resize(static_cast<std::size_t>(array.size()));
    double time = -1.0;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        if (const auto fault = parseSample(array.at(static_cast<qsizetype>(i)), time, stroke.samples[i])) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(place).arg(i), *fault));
            break;
        }
        time = stroke.samples[i].time;
    }
    return stroke;
}

bool OperationsParser::admit(JsonReader& reader, QLatin1StringView key, qsizetype samples)
{
    m_samples += samples;
    if (m_samples > recipeLimits::kSamples)
        reader.fail(key, Text::tr("a recipe has at most %1 samples").arg(recipeLimits::kSamples));
    return m_samples <= recipeLimits::kSamples;
}

RecipeOperation OperationsParser::parseLasso(JsonReader& reader)
{
    LassoOperation lasso;
    lasso.competitors = parseCompetitors(reader);
    const auto readVector = [&](QLatin1StringView key, Vec3& vector) {
        if (!reader.has(key))
            return;
        if (const auto read = numbers<3>(reader.array(key), recipeLimits::kCoordinate))
            vector = *read;
        else
            reader.fail(key,
                        Text::tr("three numbers within ±%1 are expected").arg(recipeLimits::kCoordinate));
    };
    readVector(QLatin1StringView("origin"), lasso.stroke.origin);
    readVector(QLatin1StringView("right"), lasso.stroke.right);
    readVector(QLatin1StringView("up"), lasso.stroke.up);
    if (!isLasso(lasso.stroke))
        reader.fail(QLatin1StringView("up"),
                    Text::tr("right and up must have length 1 and be at right angles"));

    const QJsonArray array = reader.array(kPointsKey);
    if (array.size() < 3)
        reader.fail(kPointsKey, Text::tr("a lasso has at least three points"));
    if (!admit(reader, kPointsKey, array.size()))
        return lasso;
    lasso.stroke.points.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const auto point = numbers<2>(array.at(i).toArray(), recipeLimits::kCoordinate);
        if (!point) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kPointsKey)).arg(i),
                                   Text::tr("two numbers within ±%1 are expected, right and up, in m")
                                       .arg(recipeLimits::kCoordinate)));
            break;
        }
        lasso.stroke.points.push_back(*point);
    }
    return lasso;
}

RecipeOperation OperationsParser::parsePrune(JsonReader& reader)
{
    const QLatin1StringView key("internodes");
    const QJsonArray array = reader.array(key);
    PruneOperation operation;
    if (array.isEmpty() || array.size() > recipeLimits::kCuts)
        reader.fail(key, Text::tr("1 to %1 internodes are expected").arg(recipeLimits::kCuts));
    for (const QJsonValue& value : array) {
        const double number = value.toDouble(-1.0);
        if (!(number >= 0.0 && number < kNoInternode && number == std::floor(number))) {
            reader.fail(key, Text::tr("a list of internodes' numbers is expected"));
            break;
        }
        operation.internodes.push_back(static_cast<InternodeId>(number));
    }
    return operation;
}

std::optional<QString> OperationsParser::parseSample(const QJsonValue& value, double previousTime,
                                                     BrushSample& sample) const
{
    const QJsonArray array = value.toArray();
    std::array<double, 5> numbers{};
    bool good = array.size() == 5;
    for (qsizetype i = 0; good && i < 5; ++i) {
        good = array.at(i).isDouble();
        numbers[static_cast<std::size_t>(i)] = array.at(i).toDouble();
    }
    if (!good)
        return Text::tr("an array of five numbers is expected: time, x, y, z, radius");
    const auto& [time, x, y, z, radius] = numbers;
    if (!(time >= 0.0 && time <= recipeLimits::kStrokeTime))
        return Text::tr("the time is not within 0…%1 s").arg(recipeLimits::kStrokeTime);
    if (time <= previousTime)
        return Text::tr("the time does not go forwards");
    for (const double coordinate : {x, y, z}) {
        if (!(std::abs(coordinate) <= recipeLimits::kCoordinate))
            return Text::tr("a coordinate is not within ±%1 m").arg(recipeLimits::kCoordinate);
    }
    if (!(radius >= 0.0 && radius <= recipeLimits::kRadius))
        return Text::tr("the radius is not within 0…%1 m").arg(recipeLimits::kRadius);
    sample = {time, Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)),
              static_cast<float>(radius)};
    return {};
}

InternodeId internode(JsonReader& reader, QLatin1StringView key)
{
    return static_cast<InternodeId>(reader.integer(key, 0, recipeLimits::kInternode));
}

std::optional<Vec3> point(const QJsonArray& array)
{
    Vec3 place;
    for (qsizetype i = 0; i < 3; ++i) {
        const double coordinate = array.at(i).toDouble(std::numeric_limits<double>::quiet_NaN());
        if (array.size() != 3 || !(std::abs(coordinate) <= recipeLimits::kCoordinate))
            return std::nullopt;
        place[i] = static_cast<float>(coordinate);
    }
    return place;
}

RecipeOperation OperationsParser::parseBend(JsonReader& reader)
{
    const QLatin1StringView handlesKey("handles");
    const QLatin1StringView targetKey("target");
    BendOperation bend;
    bend.base = internode(reader, QLatin1StringView("base"));
    for (auto& [key, weight] : {std::pair(QLatin1StringView("bending"), &bend.bending),
                                std::pair(QLatin1StringView("stretching"), &bend.stretching)})
        *weight = reader.number(key, recipeLimits::kLeastWeight, recipeLimits::kGreatestWeight, *weight);
    const QJsonArray handles = reader.array(handlesKey);
    if (handles.isEmpty() || handles.size() > recipeLimits::kHandles)
        reader.fail(handlesKey, Text::tr("a bend has from 1 to %1 handles").arg(recipeLimits::kHandles));
    const QString place = reader.placeOf(handlesKey);
    for (qsizetype i = 0; i < std::min(handles.size(), recipeLimits::kHandles); ++i) {
        const QString placeHere = QStringLiteral("%1[%2]").arg(place).arg(i);
        if (!handles.at(i).isObject()) {
            reader.fail(inputError(placeHere, Text::tr("an object is expected")));
            break;
        }
        JsonReader handle(handles.at(i).toObject(), placeHere);
        BendOperation::Handle& held = bend.handles.emplace_back();
        held.internode = internode(handle, QLatin1StringView("internode"));
        held.along = handle.number(QLatin1StringView("along"), 0.0, 1.0, held.along);
        if (const auto target = point(handle.array(targetKey)))
            held.target = *target;
        else
            handle.fail(
                targetKey,
                Text::tr("an array of three numbers within ±%1 is expected").arg(recipeLimits::kCoordinate));
        if (const Result<void> end = handle.finish(); !end)
            reader.fail(end.error());
    }
    return bend;
}

RecipeOperation OperationsParser::parseWidth(JsonReader& reader)
{
    return SetWidthOperation{internode(reader, QLatin1StringView("internode")),
                             reader.number(QLatin1StringView("diameter"), 0.0, recipeLimits::kDiameter)};
}

RecipeCamera parseCamera(JsonReader& parent)
{
    const QLatin1StringView key("camera");
    JsonReader reader(parent.object(key), parent.placeOf(key));
    RecipeCamera camera;
    camera.view = reader.text(QLatin1StringView("view"), QString());
    if (reader.has(QLatin1StringView("view")) && std::ranges::find(kViews, camera.view) == std::end(kViews)) {
        reader.fail(
            QLatin1StringView("view"),
            Text::tr("there is no view “%1”; there are front, side, top and three-quarter").arg(camera.view));
    }
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
    return camera;
}

} // namespace

Result<Recipe> parseRecipe(const QByteArray& json, const QString& folder)
{
    const Result<QJsonObject> parsed = parseJsonObject(json, recipeLimits::kBytes);
    if (!parsed)
        return parsed.error();
    JsonReader reader(*parsed, {});
    if (!reader.has(recipeLimits::kVersionKey)) {
        return inputError({}, Text::tr("this is no recipe: one begins with “%1”: %2")
                                  .arg(QString(recipeLimits::kVersionKey))
                                  .arg(recipeLimits::kVersion));
    }
    const auto version =
        reader.integer(recipeLimits::kVersionKey, 1, std::numeric_limits<std::int32_t>::max());
    if (version > recipeLimits::kVersion) {
        return inputError({}, Text::tr("the recipe is of version %1, this program reads versions up to %2")
                                  .arg(version)
                                  .arg(recipeLimits::kVersion));
    }
    Recipe recipe;
    recipe.name = reader.text(QLatin1StringView("name"), QString());
    recipe.description = reader.text(QLatin1StringView("description"), QString());
    recipe.seed = reader.seed(QLatin1StringView("seed"), 1);
    ParametersParser parametersParser(folder);
    Result<TreeParameters> parameters =
        parametersParser.parse(reader.object(kParametersKey), {}, QString(kParametersKey));
    if (!parameters)
        reader.fail(parameters.error());
    else
        recipe.parameters = *parameters;
    normaliseDirectionWeights(recipe.parameters.growth);
    recipe.camera = parseCamera(reader);
    const QJsonArray operations = reader.array(QLatin1StringView("operations"));
    if (operations.size() > recipeLimits::kOperations) {
        reader.fail(QLatin1StringView("operations"),
                    Text::tr("a recipe has at most %1 operations").arg(recipeLimits::kOperations));
    }
    if (const Result<void> end = reader.finish(); !end)
        return end.error();

    OperationsParser parser(recipe.parameters, parametersParser);
    recipe.operations.reserve(static_cast<std::size_t>(operations.size()));
    for (qsizetype i = 0; i < operations.size(); ++i) {
        Result<RecipeOperation> operation =
            parser.parse(operations.at(i), QStringLiteral("operations[%1]").arg(i));
        if (!operation)
            return operation.error();
        recipe.operations.push_back(std::move(*operation));
    }
    return recipe;
}

Result<Recipe> readRecipe(const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        return inputError(name, file.errorString());
    // One byte too many is enough to know that a file is too large; a pipe has no size.
    const qint64 size =
        file.isSequential() ? recipeLimits::kBytes : std::min<qint64>(file.size(), recipeLimits::kBytes);
    Result<Recipe> recipe = parseRecipe(file.read(size + 1), QFileInfo(fileName).path());
    if (!recipe)
        return inputError(name, recipe.error().message);
    return recipe;
}

} // namespace espalier
