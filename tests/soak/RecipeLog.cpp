// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/RecipeLog.h"

namespace espalier::test {

namespace {

constexpr QByteArrayView kOperations("\"operations\": [");
constexpr QByteArrayView kEnd("\n  ]\n}\n");

} // namespace

RecipeLog::RecipeLog(const QString& fileName, const Recipe& beginning)
    : m_file(fileName), m_parameters(beginning.parameters)
{
    Recipe empty = beginning;
    empty.operations.clear();
    const QByteArray text = writeRecipe(empty);
    m_isGood = m_file.open(QIODevice::WriteOnly);
    m_end = text.indexOf(kOperations) + kOperations.size();
    write(text.left(m_end));
}

bool RecipeLog::add(const RecipeOperation& operation)
{
    Recipe one;
    one.parameters = m_parameters;
    one.operations = {operation};
    const QByteArray text = writeRecipe(one);
    const qsizetype begin = text.indexOf(kOperations) + kOperations.size();
    const QByteArray added = (m_isFirst ? "" : ",") + text.mid(begin, text.size() - begin - kEnd.size());
    m_isFirst = false;
    m_isGood = m_isGood && m_file.seek(m_end);
    m_end += added.size();
    write(added);
    if (const auto* set = std::get_if<SetParametersOperation>(&operation))
        m_parameters = set->parameters;
    return m_isGood;
}

void RecipeLog::write(const QByteArray& text)
{
    const QByteArray whole = text + kEnd.toByteArray();
    m_isGood = m_isGood && m_file.write(whole) == whole.size() && m_file.flush();
}

} // namespace espalier::test
