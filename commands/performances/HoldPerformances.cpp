// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/InvigorateGesture.h"
#include "commands/ReduceGesture.h"
#include "commands/recipe/InvigorateOperation.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/ReduceOperation.h"

#include <algorithm>

namespace espalier {

namespace {

/// A held press in its own time.
template <class Gesture>
class HoldPerformance : public Performance {
public:
    HoldPerformance(TreeDocument& document, const InternodeReference& internode, double seconds,
                    QString nothing)
        : m_end(seconds), m_nothing(std::move(nothing))
    {
        if (const Result<InternodeId> id = internode.resolve(document))
            m_gesture = std::make_unique<Gesture>(document, *id);
        else
            m_warning = id.error().message;
    }

    bool advance(double seconds) override
    {
        if (!m_gesture)
            return true;
        m_time = std::min(m_time + seconds, m_end);
        m_gesture->holdTo(m_time);
        if (m_time < m_end)
            return false;
        m_gesture->finish();
        if (m_gesture->changeCount() == 0)
            m_warning = m_nothing;
        return true;
    }
    QString warning() const override { return m_warning; }

private:
    double m_end;
    double m_time = 0.0;
    QString m_nothing;
    QString m_warning;
    std::unique_ptr<Gesture> m_gesture; ///< Null if the branch was not found
};

} // namespace

std::unique_ptr<Performance> InvigorateOperation::begin(TreeDocument& document) const
{
    return std::make_unique<HoldPerformance<InvigorateGesture>>(document, internode, seconds,
                                                                RecipeText::tr("nothing grew"));
}

std::unique_ptr<Performance> ReduceOperation::begin(TreeDocument& document) const
{
    return std::make_unique<HoldPerformance<ReduceGesture>>(document, internode, seconds,
                                                            RecipeText::tr("nothing was taken away"));
}

} // namespace espalier
