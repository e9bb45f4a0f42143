// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ParameterGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/SetParametersOperation.h"

namespace espalier {

std::unique_ptr<Edit> ParameterGesture::takeEdit()
{
    const bool isLast = m_revision == m_document.revision();
    m_revision.reset();
    if (isLast)
        return Edit::resumed(m_document, Edit::Kind::ParameterTrial);
    return std::make_unique<Edit>(m_document, Edit::Interrupted(), Edit::Kind::ParameterTrial);
}

bool ParameterGesture::tryOut(const TreeParameters& parameters, const QString& text)
{
    if (parameters == m_document.parameters())
        return true;
    if (!m_document.tree().hasRoomFor(parameters))
        return false;
    const std::unique_ptr<Edit> edit = takeEdit();
    edit->takeBack();
    const Tree& tree = m_document.tree();
    TreeDelta delta = deltaStartingAt(tree);
    delta.parametersAfter = keepParameters(delta, tree, parameters);
    edit->apply(std::move(delta));
    const bool isTried = edit->deltaCount() > 0;
    commitRecorded(*edit, text, [&] { return SetParametersOperation{parameters}; });
    if (isTried)
        m_revision = m_document.revision();
    return true;
}

void ParameterGesture::cancel()
{
    if (m_revision == m_document.revision())
        takeEdit()->cancel();
    m_revision.reset();
}

} // namespace espalier
