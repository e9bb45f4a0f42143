// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/RecipeLog.h"

#include <QJsonDocument>

#include <utility>

namespace espalier::test {

namespace {

constexpr QByteArrayView kOperations("\"operations\":[");

} // namespace

RecipeLog::RecipeLog(const QString& fileName, const Recipe& beginning)
    : m_file(fileName), m_writing{beginning.parameters}
{
    Recipe empty = beginning;
    empty.operations.clear();
    const QByteArray text = QJsonDocument::fromJson(writeRecipe(empty)).toJson(QJsonDocument::Compact);
    const qsizetype end = text.indexOf(kOperations) + kOperations.size();
    m_rest = text.mid(end);
    m_isGood = m_file.open(QIODevice::WriteOnly);
    write(text.left(end));
}

bool RecipeLog::add(const RecipeOperation& operation)
{
    const QByteArray json = QJsonDocument(operation.write(m_writing)).toJson(QJsonDocument::Compact);
    write((std::exchange(m_isFirst, false) ? "\n" : ",\n") + json);
    return m_isGood;
}

void RecipeLog::write(const QByteArray& text)
{
    const QByteArray whole = text + m_rest;
    m_isGood = m_isGood && m_file.seek(m_end) && m_file.write(whole) == whole.size() && m_file.flush();
    m_end += text.size();
}

} // namespace espalier::test
