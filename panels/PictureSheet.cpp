// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/PictureSheet.h"

#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace espalier {

namespace {

/// In the order of the box; before them is the window's size, after them any other one.
constexpr std::array kPresets{QSize(1920, 1080), QSize(3840, 2160), QSize(1080, 1080), QSize(2048, 2048),
                              QSize(1080, 1350)};
constexpr int kCustomPreset = static_cast<int>(kPresets.size()) + 1;
constexpr int kBoxWidth = 260;

QStringList presetNames(const QSize& window)
{
    return {PictureSheet::tr("Like the window, %1 × %2").arg(window.width()).arg(window.height()),
            PictureSheet::tr("Full HD, 1920 × 1080"),
            PictureSheet::tr("4K, 3840 × 2160"),
            PictureSheet::tr("Square, 1080 × 1080"),
            PictureSheet::tr("Large square, 2048 × 2048"),
            PictureSheet::tr("Portrait, 1080 × 1350"),
            PictureSheet::tr("Another size")};
}

QSpinBox* makeEdge(const char* name, const QString& label, QWidget* parent)
{
    auto* edge = new QSpinBox(parent);
    edge->setObjectName(QString::fromLatin1(name));
    edge->setAccessibleName(label);
    edge->setRange(PictureSettings::kLeastEdge, PictureSettings::kMostEdge);
    edge->setSuffix(PictureSheet::tr(" px"));
    edge->setButtonSymbols(QAbstractSpinBox::NoButtons);
    edge->setMinimumHeight(theme::kTarget);
    return edge;
}

} // namespace

PictureSheet::PictureSheet(const PictureSettings& settings, const QSize& window, QWidget* parent)
    : QDialog(parent),
      m_window(window),
      m_preset(new QComboBox(this)),
      m_width(makeEdge("pictureWidth", tr("Width"), this)),
      m_height(makeEdge("pictureHeight", tr("Height"), this)),
      m_view(new QComboBox(this)),
      m_transparent(new Toggle(tr("Transparent background"), this)),
      m_shadow(new Toggle(tr("With the shadow on the ground"), this))
{
    setWindowTitle(tr("Save Picture"));
    m_preset->setObjectName(QStringLiteral("pictureSize"));
    m_preset->addItems(presetNames(window));
    m_view->setObjectName(QStringLiteral("pictureView"));
    m_view->addItems({tr("As shown now"), tr("From the front"), tr("From the side"), tr("From the top"),
                      tr("Three-quarter")});
    m_transparent->setObjectName(QStringLiteral("pictureTransparent"));
    m_transparent->setToolTip(tr("Nothing is behind the tree, so that it can be laid over other pictures."));
    m_shadow->setObjectName(QStringLiteral("pictureShadow"));
    for (QComboBox* box : {m_preset, m_view}) {
        box->setMinimumHeight(theme::kTarget);
        box->setMinimumWidth(kBoxWidth);
    }
    for (QCheckBox* box : {m_transparent, m_shadow})
        box->setMinimumHeight(theme::kTarget);

    auto* form = new QFormLayout;
    form->setHorizontalSpacing(18);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const auto label = [this](const QString& text, QWidget* buddy) {
        auto* made = new QLabel(text, this);
        made->setMinimumHeight(theme::kTarget);
        made->setBuddy(buddy);
        return made;
    };
    form->addRow(label(tr("Size"), m_preset), m_preset);
    form->addRow(QString(), makeSize());
    form->addRow(label(tr("View"), m_view), m_view);
    form->addRow(label(tr("Background"), m_transparent), m_transparent);
    form->addRow(QString(), m_shadow);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(26, 20, 26, 20);
    all->setSpacing(18);
    all->addLayout(form);
    all->addLayout(makeButtons());
    all->setSizeConstraint(QLayout::SetFixedSize);

    connect(m_preset, &QComboBox::activated, this, &PictureSheet::showPreset);
    for (QSpinBox* edge : {m_width, m_height})
        connect(edge, &QSpinBox::valueChanged, this, &PictureSheet::findPreset);
    connect(m_transparent, &QCheckBox::toggled, m_shadow, &QWidget::setEnabled);
    showSettings(settings);
}

QLayout* PictureSheet::makeSize()
{
    auto* line = new QHBoxLayout;
    line->setSpacing(8);
    line->addWidget(m_width, 1);
    line->addWidget(new QLabel(QStringLiteral("×"), this));
    line->addWidget(m_height, 1);
    return line;
}

QLayout* PictureSheet::makeButtons()
{
    auto* copy = new QPushButton(tr("Copy"), this);
    copy->setObjectName(QStringLiteral("pictureCopy"));
    copy->setToolTip(tr("Put the picture on the clipboard."));
    auto* cancel = new QPushButton(tr("Cancel"), this);
    auto* save = new QPushButton(tr("Save…"), this);
    save->setObjectName(QStringLiteral("pictureSave"));
    save->setDefault(true);
    auto* line = new QHBoxLayout;
    line->addWidget(copy);
    line->addStretch(1);
    line->addWidget(cancel);
    line->addWidget(save);
    for (QPushButton* button : {copy, cancel, save})
        button->setMinimumSize(110, theme::kTarget);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(copy, &QPushButton::clicked, this, [this] {
        accept();
        Q_EMIT copyAsked(settings());
    });
    connect(save, &QPushButton::clicked, this, [this] {
        accept();
        Q_EMIT saveAsked(settings());
    });
    return line;
}

PictureSettings PictureSheet::settings() const
{
    PictureSettings settings;
    if (m_preset->currentIndex() != 0)
        settings.size = {m_width->value(), m_height->value()};
    settings.view = static_cast<PictureSettings::View>(m_view->currentIndex());
    settings.transparent = m_transparent->isChecked();
    settings.shadow = m_shadow->isChecked();
    return settings;
}

void PictureSheet::showSettings(const PictureSettings& settings)
{
    m_view->setCurrentIndex(static_cast<int>(settings.view));
    m_transparent->setChecked(settings.transparent);
    m_shadow->setChecked(settings.shadow);
    m_shadow->setEnabled(settings.transparent);
    if (settings.size.isEmpty()) {
        m_preset->setCurrentIndex(0);
        showPreset();
    } else {
        m_preset->setCurrentIndex(kCustomPreset);
        m_width->setValue(settings.size.width());
        m_height->setValue(settings.size.height());
        findPreset();
    }
}

/// Shows the edges of the size that is chosen.
void PictureSheet::showPreset()
{
    const int preset = m_preset->currentIndex();
    if (preset == kCustomPreset)
        return;
    const QSize size = preset == 0 ? m_window : kPresets[static_cast<std::size_t>(preset - 1)];
    m_isShowing = true;
    m_width->setValue(size.width());
    m_height->setValue(size.height());
    m_isShowing = false;
}

/// Shows which size the edges make.
void PictureSheet::findPreset()
{
    if (m_isShowing)
        return;
    const auto* preset = std::ranges::find(kPresets, QSize(m_width->value(), m_height->value()));
    m_preset->setCurrentIndex(preset == kPresets.end() ? kCustomPreset
                                                       : static_cast<int>(preset - kPresets.begin()) + 1);
}

} // namespace espalier
