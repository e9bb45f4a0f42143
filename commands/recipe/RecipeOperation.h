// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Performance.h"
#include "commands/recipe/RecipeReading.h"
#include "model/document/TreeDocument.h"
#include "model/io/JsonReader.h"

#include <concepts>
#include <memory>

namespace espalier {

/// The state while operations are written one after another.
struct RecipeWriting {
    TreeParameters parameters; ///< In force after the operations written so far
};

/// The data of one kind of operation: its name in JSON, its reader and its writer. The reader reads the
/// members of the operation's object and reports errors to the JsonReader. The writer returns an object from
/// which the reader reads the same data.
template <class Data>
concept OperationData = std::equality_comparable<Data> &&
    requires(const Data& data, JsonReader& reader, RecipeReading& reading, RecipeWriting& writing)
{
    {
        Data::kName
        } -> std::convertible_to<QLatin1StringView>;
    {
        Data::read(reader, reading)
        } -> std::same_as<Data>;
    {
        data.write(writing)
        } -> std::same_as<QJsonObject>;
};

/// An operation that happens at once: perform() returns the text for Performance::warning().
template <class Data>
concept ImmediateOperation = OperationData<Data> && requires(const Data& data, TreeDocument& document)
{
    {
        data.perform(document)
        } -> std::same_as<QString>;
};

/// An operation that takes time: begin() starts it. The performance may refer to the data.
template <class Data>
concept TimedOperation = OperationData<Data> && requires(const Data& data, TreeDocument& document)
{
    {
        data.begin(document)
        } -> std::same_as<std::unique_ptr<Performance>>;
};

/// One operation of a recipe, of any kind, as data. A value that never changes; copies share their data. Each
/// kind is a plain struct in a file of its own (PruneOperation.h) and is registered by its line in
/// RecipeOperations.cpp. docs/recipes.md and resources/recipe.schema.json describe the JSON.
class RecipeOperation {
public:
    template <class Data>
    requires ImmediateOperation<Data> || TimedOperation<Data> RecipeOperation(Data data)
        : m_content(std::make_shared<const Content<Data>>(std::move(data)))
    {
    }

    /// The value of "op" in JSON.
    QLatin1StringView name() const { return m_content->name(); }
    /// The data, or null if the operation is of another kind.
    template <class Data>
    const Data* as() const
    {
        const auto* content = dynamic_cast<const Content<Data>*>(m_content.get());
        return content ? &content->data : nullptr;
    }
    /// False if the operation happens at once.
    bool takesTime() const { return m_content->takesTime(); }
    /// The space that the operation itself draws in, m; empty if it draws nothing.
    Box3 reach() const { return m_content->reach(); }

    /// The object, with its name, from which readOperation() reads the same operation after the same ones.
    QJsonObject write(RecipeWriting& writing) const;
    /// The same as compact JSON, written relative to @p parameters, those in force after the operation. A
    /// gesture leaves it in the journal (EditRecord).
    QByteArray record(const TreeParameters& parameters) const;
    /// Starts the operation on @p document. The operation must outlive the performance.
    std::unique_ptr<Performance> begin(TreeDocument& document) const { return m_content->begin(document); }

    bool operator==(const RecipeOperation& other) const { return m_content->equals(*other.m_content); }

private:
    class AnyContent {
    public:
        virtual ~AnyContent() = default;
        virtual QLatin1StringView name() const = 0;
        virtual bool takesTime() const = 0;
        virtual Box3 reach() const = 0;
        virtual QJsonObject write(RecipeWriting& writing) const = 0;
        virtual std::unique_ptr<Performance> begin(TreeDocument& document) const = 0;
        virtual bool equals(const AnyContent& other) const = 0;
    };

    template <class Data>
    class ImmediatePerformance final : public Performance {
    public:
        ImmediatePerformance(const Data& data, TreeDocument& document) : m_data(data), m_document(document) {}

        bool advance(double) override
        {
            m_warning = m_data.perform(m_document);
            return true;
        }
        QString warning() const override { return m_warning; }

    private:
        const Data& m_data;
        TreeDocument& m_document;
        QString m_warning;
    };

    template <class Data>
    class Content final : public AnyContent {
    public:
        explicit Content(Data operationData) : data(std::move(operationData)) {}

        QLatin1StringView name() const override { return Data::kName; }
        bool takesTime() const override { return TimedOperation<Data>; }
        Box3 reach() const override
        {
            if constexpr (requires { data.reach(); })
                return data.reach();
            else
                return {};
        }
        QJsonObject write(RecipeWriting& writing) const override { return data.write(writing); }
        std::unique_ptr<Performance> begin(TreeDocument& document) const override
        {
            if constexpr (TimedOperation<Data>)
                return data.begin(document);
            else
                return std::make_unique<ImmediatePerformance<Data>>(data, document);
        }
        bool equals(const AnyContent& other) const override
        {
            const auto* content = dynamic_cast<const Content*>(&other);
            return content && content->data == data;
        }

        const Data data;
    };

    std::shared_ptr<const AnyContent> m_content;
};

/// The names of all kinds of operations, as in JSON, in the order of RecipeOperations.cpp.
QStringList operationNames();

/// Reads one operation; @p place is its place in the recipe ("operations[3]"), for errors.
Result<RecipeOperation> readOperation(const QJsonValue& value, const QString& place, RecipeReading& reading);

} // namespace espalier
