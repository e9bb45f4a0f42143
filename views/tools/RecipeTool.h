// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/performances/RecipeReplica.h"
#include "views/tools/EnvelopeView.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <functional>

namespace espalier {

/// Shows the brush of a recipe that is playing, and prevents other strokes meanwhile.
class RecipeTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(RecipeTool)

public:
    /// @p moment returns what there is to show of the recipe, or null while none plays.
    RecipeTool(ToolContext& context, std::function<const RecipeMoment*()> moment)
        : Tool(context), m_moment(std::move(moment))
    {
    }

    void begin(const PointerSample&) override {}
    void move(const PointerSample&) override {}
    void end(const PointerSample&) override {}
    void finish() override {}
    void cancel() override {}
    bool isActive() const override { return false; }
    void paint(Overlay& overlay) const override;
    QCursor cursor() const override { return Qt::ArrowCursor; }
    QString tip() const override { return tr("A recipe is playing; Escape hands the brush to you."); }

private:
    std::function<const RecipeMoment*()> m_moment;
    mutable EnvelopeView m_envelopes; ///< Made when they are painted
};

} // namespace espalier
