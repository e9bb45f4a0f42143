// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/EnvelopeGrowth.h"
#include "model/document/TreeDocument.h"

#include <memory>

namespace espalier {

/// Growth into what lassos enclose: each step shows at once; finish() makes all of it, and the envelope, one
/// undo step, whether growth has come to its end or not; cancel() takes it back, and so does destroying the
/// gesture unfinished.
class LassoGesture {
public:
    using Begun = Result<std::unique_ptr<LassoGesture>>;

    /// Adds the envelope that @p stroke stands for, and starts to fill all that are in force. The stroke may
    /// be raw; its ends are joined. An Error, and nothing changed, if it encloses nothing.
    static Begun fill(TreeDocument& document, const LassoStroke& stroke, Competitors competitors = {});
    /// Takes the tree back to where it stood before the first of the envelopes in force was drawn, and starts
    /// to fill them all with the parameters that are in force now. What has been done to the tree since goes
    /// too. An Error, and nothing changed, if there is no envelope.
    static Begun regrow(TreeDocument& document);

    ~LassoGesture();
    LassoGesture(const LassoGesture&) = delete;
    LassoGesture& operator=(const LassoGesture&) = delete;

    /// Grows one step; false, and nothing changed, if growth has come to its end.
    bool step();
    void finish();
    void cancel();

    /// The living markers of free space, for showing them.
    std::span<const Vec3> markers() const { return m_growth.markers(); }
    const EnvelopeSet& envelopes() const { return m_growth.envelopes(); }

private:
    /// @p first stands applied.
    LassoGesture(TreeDocument& document, QString text, EnvelopeSet envelopes, Competitors competitors,
                 Journal replaced, std::shared_ptr<TreeDelta> first, std::uint32_t lassosBefore);

    TreeDocument& m_document;
    QString m_text;
    EnvelopeGrowth m_growth;
    Journal m_replaced;
    Journal m_deltas;
    std::uint32_t m_lassosBefore;
    bool m_ended = false;
};

/// Takes the envelopes in force away, as one undo step; the tree stays as it grew. False if there are none.
bool removeEnvelopes(TreeDocument& document);

} // namespace espalier
