// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LassoPopOut.h"

#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

LassoPopOut::LassoPopOut(const TreeDocument& document, ViewSettings& settings, QWidget* parent)
    : Bar(parent),
      m_document(document),
      m_settings(settings),
      m_regrow(new QPushButton(tr("Regrow"), this)),
      m_remove(new QPushButton(tr("Remove"), this)),
      m_stop(new QPushButton(tr("Stop here"), this)),
      m_envelope(new Toggle(tr("Envelope"), this)),
      m_markers(new Toggle(tr("Markers"), this))
{
    m_regrow->setObjectName(QStringLiteral("lassoRegrow"));
    m_regrow->setToolTip(tr("<b>Regrow</b><br>Take the tree back to how it was before its envelope was "
                            "drawn, and let it fill the envelope again with the parameters that are in force "
                            "now. What you have done to it since is lost."));
    m_remove->setObjectName(QStringLiteral("lassoRemove"));
    m_remove->setToolTip(tr("<b>Remove</b><br>Take the envelope away; the tree stays as it grew."));
    m_stop->setObjectName(QStringLiteral("lassoStop"));
    m_stop->setToolTip(tr("Keep what has grown. Escape takes it back instead."));
    m_envelope->setObjectName(QStringLiteral("lassoShow"));
    m_envelope->setToolTip(tr("Show the envelope."));
    m_markers->setToolTip(tr("Show the points of free space that the tree grows into."));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 6);
    column->setSpacing(6);
    for (QPushButton* button : {m_regrow, m_remove, m_stop}) {
        button->setMinimumHeight(theme::kTarget);
        button->setFocusPolicy(Qt::TabFocus);
        column->addWidget(button);
    }
    column->addWidget(m_envelope);
    column->addWidget(m_markers);

    connect(m_regrow, &QPushButton::clicked, this, &LassoPopOut::regrowAsked);
    connect(m_remove, &QPushButton::clicked, this, &LassoPopOut::removeAsked);
    connect(m_stop, &QPushButton::clicked, this, &LassoPopOut::stopAsked);
    connect(m_envelope, &QCheckBox::toggled, this,
            [this](bool on) { m_settings.set(&ViewValues::envelopeShown, on); });
    connect(m_markers, &QCheckBox::toggled, this,
            [this](bool on) { m_settings.set(&ViewValues::markersShown, on); });
    connect(&settings, &ViewSettings::changed, this, &LassoPopOut::showValues);
    connect(&document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (!change.delta || !change.delta->lassos.empty())
            showValues();
    });
    showValues();
}

void LassoPopOut::setGrowing(bool growing)
{
    m_isGrowing = growing;
    showValues();
}

void LassoPopOut::showValues()
{
    const bool stands = !m_document.tree().lassoIndicesInForce().empty();
    m_regrow->setEnabled(stands && !m_isGrowing);
    m_remove->setEnabled(stands && !m_isGrowing);
    m_stop->setEnabled(m_isGrowing);
    m_envelope->setChecked(m_settings.values().envelopeShown);
    m_markers->setChecked(m_settings.values().markersShown);
}

} // namespace espalier
