// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

class QPushButton;

namespace espalier {

class Toggle;

/// Controls for the envelopes in force. The widget only emits signals.
class LassoPopOut : public Bar {
    Q_OBJECT

public:
    LassoPopOut(const TreeDocument& document, ViewSettings& settings, QWidget* parent = nullptr);

    /// While the tree fills an envelope, the only enabled control is the one that ends this.
    void setGrowing(bool growing);

Q_SIGNALS:
    void regrowAsked();
    void removeAsked();
    /// The user wants to end growth and keep what has grown.
    void stopAsked();

private:
    void showValues();

    const TreeDocument& m_document;
    ViewSettings& m_settings;
    QPushButton* m_regrow;
    QPushButton* m_remove;
    QPushButton* m_stop;
    Toggle* m_envelope;
    Toggle* m_markers;
    bool m_isGrowing = false;
};

} // namespace espalier
