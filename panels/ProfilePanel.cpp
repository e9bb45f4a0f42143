// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ProfilePanel.h"

#include "model/settings/Lengths.h"
#include "model/strands/ProfileShapes.h"
#include "panels/Theme.h"

#include <QButtonGroup>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kShapeIcon = 26;

/// A picture of a ready-made profile: filled, its cavities empty.
QIcon shapeIcon(ProfileShape shape)
{
    constexpr int kFactor = 3; // For dense screens
    QPixmap pixmap(kFactor * kShapeIcon, kFactor * kShapeIcon);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(pixmap.width() / 2.0, pixmap.height() / 2.0);
    const double scale = pixmap.width() / 3.5;
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (const StrandProfile::Loop& loop : profileOf(shape).boundaries) {
        QPolygonF polygon;
        for (const Vec2& point : loop)
            polygon.append(scale * QPointF(double{point.x()}, double{point.y()}));
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    painter.setPen(QPen(theme::kAccentText, 4.0));
    painter.setBrush(theme::kAccentFill);
    painter.drawPath(path);
    return pixmap;
}

} // namespace

ProfilePanel::ProfilePanel(QWidget* parent)
    : Bar(parent),
      m_canvas(new ProfileCanvas(this)),
      m_title(new QLabel(this)),
      m_message(new QLabel(this)),
      m_modes(new QButtonGroup(this))
{
    m_title->setObjectName(QStringLiteral("profileTitle"));
    m_message->setObjectName(QStringLiteral("profileMessage"));
    m_message->setWordWrap(true);
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    m_message->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 12);
    column->setSpacing(6);
    column->addWidget(m_title);
    column->addWidget(m_canvas, 1);
    addModes(*column);
    column->addWidget(m_message);
    addShapes(*column);
    addActions(*column);
    connect(m_canvas, &ProfileCanvas::edited, this, &ProfilePanel::edited);
    connect(m_canvas, &ProfileCanvas::faultChanged, this,
            [this](const QString& sentence) { tell(sentence, !sentence.isEmpty()); });
    showNothing();
}

void ProfilePanel::addModes(QVBoxLayout& column)
{
    struct ModeText {
        ProfileCanvas::Mode mode;
        const char* name;
        QString text;
        QString toolTip;
    };
    const ModeText modes[] = {
        {ProfileCanvas::Mode::Outline, "profileOutline", tr("Outline"),
         tr("<b>Outline</b><br>Draw a closed line. One beside another splits the wood; one within another is "
            "a hollow.")},
        {ProfileCanvas::Mode::Attractor, "profileAttractor", tr("Attractor"),
         tr("<b>Attractor</b><br>Drag a straight line that the strands gather at.")},
        {ProfileCanvas::Mode::Points, "profilePoints", tr("Points"),
         tr("<b>Points</b><br>Drag the points of an outline, or the ends of an attractor.")},
        {ProfileCanvas::Mode::Erase, "profileErase", tr("Erase"),
         tr("<b>Erase</b><br>Tap a line to take it away. A pen's eraser does the same at any time.")},
    };
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (const ModeText& mode : modes) {
        auto* button = new BarButton(BarButton::Look::Tab, this);
        button->setObjectName(QString::fromLatin1(mode.name));
        button->setText(mode.text);
        button->setToolTip(mode.toolTip);
        button->setAccessibleName(mode.text);
        button->setCheckable(true);
        button->setChecked(mode.mode == m_canvas->mode());
        button->setFocusPolicy(Qt::TabFocus);
        m_modes->addButton(button, static_cast<int>(mode.mode));
        row->addWidget(button);
    }
    row->addStretch(1);
    column.addLayout(row);
    connect(m_modes, &QButtonGroup::idClicked, this, [this](int id) {
        m_canvas->setMode(static_cast<ProfileCanvas::Mode>(id));
        tell({}, false);
    });
}

void ProfilePanel::addShapes(QVBoxLayout& column)
{
    const std::pair<const char*, QString> shapes[kProfileShapeCount] = {
        {"shapeRound", tr("Round")},      {"shapeElongated", tr("Elongated")},
        {"shapeC", tr("C-shaped")},       {"shapeRing", tr("Hollow")},
        {"shapeTwo", tr("Split in two")}, {"shapeThree", tr("Split in three")},
        {"shapeFluted", tr("Fluted")},
    };
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    for (int i = 0; i < kProfileShapeCount; ++i) {
        auto* button = new BarButton(BarButton::Look::Icon, this);
        button->setObjectName(QString::fromLatin1(shapes[i].first));
        button->setIcon(shapeIcon(static_cast<ProfileShape>(i)));
        button->setIconSize({kShapeIcon, kShapeIcon});
        button->setToolTip(shapes[i].second);
        button->setAccessibleName(shapes[i].second);
        button->setFocusPolicy(Qt::TabFocus);
        button->installEventFilter(this);
        m_ofNode.push_back(button);
        row->addWidget(button);
        connect(button, &QAbstractButton::clicked, this,
                [this, i] { Q_EMIT edited(profileOf(static_cast<ProfileShape>(i))); });
    }
    row->addStretch(1);
    column.addLayout(row);
}

/// The name of the shape under the pointer, or with the focus, stands in place of the advice: there is no
/// room for words below the shapes.
bool ProfilePanel::eventFilter(QObject* watched, QEvent* event)
{
    const auto* button = static_cast<const QAbstractButton*>(watched);
    const bool isNamed = event->type() == QEvent::Enter || event->type() == QEvent::FocusIn;
    if (isNamed || event->type() == QEvent::Leave || event->type() == QEvent::FocusOut) {
        m_shapeName = isNamed && button->isEnabled() ? button->accessibleName() : QString();
        if (m_faultText.isEmpty())
            tell({}, false);
    }
    return Bar::eventFilter(watched, event);
}

QPushButton* ProfilePanel::addButton(QHBoxLayout& row, const char* name, const QString& text,
                                     const QString& toolTip)
{
    auto* button = new QPushButton(text, this);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(toolTip);
    button->setMinimumHeight(theme::kTarget);
    button->setFocusPolicy(Qt::TabFocus);
    row.addWidget(button);
    return button;
}

void ProfilePanel::addActions(QVBoxLayout& column)
{
    auto* first = new QHBoxLayout;
    first->setSpacing(6);
    m_copy = addButton(*first, "profileCopy", tr("Copy to branch"),
                       tr("<b>Copy to branch</b><br>Then tap another place on this branch: everything "
                          "between gets this profile."));
    m_blend = addButton(*first, "profileBlend", tr("Blend"),
                        tr("<b>Blend</b><br>Then tap another place on this branch that has a profile: the "
                           "sections between change from one to the other."));
    auto* second = new QHBoxLayout;
    second->setSpacing(6);
    QPushButton* down = addButton(*second, "profileDown", tr("▼"), tr("To the next place down the branch."));
    QPushButton* up = addButton(*second, "profileUp", tr("▲"), tr("To the next place up the branch."));
    QPushButton* fit = addButton(*second, "profileFit", tr("Fit"), tr("Show the whole cross-section."));
    m_clear = addButton(*second, "profileClear", tr("Clear"),
                        tr("<b>Clear</b><br>Take the profile away: the strands are packed round again."));
    down->setAccessibleName(tr("Down the branch"));
    up->setAccessibleName(tr("Up the branch"));
    for (QPushButton* button : {down, up, fit})
        m_ofNode.push_back(button);
    column.addLayout(first);
    column.addLayout(second);
    for (QPushButton* button : {m_copy, m_blend})
        button->setCheckable(true);
    connect(m_copy, &QPushButton::clicked, this,
            [this](bool on) { Q_EMIT spanAsked(on ? Span::Copy : Span::None); });
    connect(m_blend, &QPushButton::clicked, this,
            [this](bool on) { Q_EMIT spanAsked(on ? Span::Blend : Span::None); });
    connect(m_clear, &QPushButton::clicked, this, &ProfilePanel::clearAsked);
    connect(down, &QPushButton::clicked, this, [this] { Q_EMIT stepAsked(false); });
    connect(up, &QPushButton::clicked, this, [this] { Q_EMIT stepAsked(true); });
    connect(fit, &QPushButton::clicked, m_canvas, &ProfileCanvas::fit);
}

void ProfilePanel::describe(double radius, std::uint32_t strands, bool hasProfile)
{
    m_title->setText(
        tr("Radius %1 · %Ln strands", nullptr, static_cast<int>(strands)).arg(lengthText(radius)));
    const bool isNew = !m_hasNode || m_hasProfile != hasProfile;
    m_hasNode = true;
    m_hasProfile = hasProfile;
    if (isNew)
        tell({}, false);
    updateEnabled();
}

void ProfilePanel::showNothing()
{
    m_title->setText(tr("Profile"));
    m_hasNode = false;
    m_hasProfile = false;
    m_canvas->clear();
    tell({}, false);
    updateEnabled();
}

void ProfilePanel::setMayEdit(bool may)
{
    m_mayEdit = may;
    updateEnabled();
}

void ProfilePanel::updateEnabled()
{
    const bool isOn = m_hasNode && m_mayEdit;
    for (QAbstractButton* button : m_ofNode)
        button->setEnabled(isOn);
    m_copy->setEnabled(isOn && (m_hasProfile || m_span == Span::Copy));
    m_blend->setEnabled(isOn && (m_hasProfile || m_span == Span::Blend));
    m_clear->setEnabled(isOn && m_hasProfile);
    m_canvas->setEnabled(!m_hasNode || m_mayEdit);
}

void ProfilePanel::setSpan(Span span)
{
    m_span = span;
    m_copy->setChecked(span == Span::Copy);
    m_blend->setChecked(span == Span::Blend);
    tell({}, false);
    updateEnabled();
}

QString ProfilePanel::advice() const
{
    switch (m_canvas->mode()) {
    case ProfileCanvas::Mode::Outline:
        return m_hasProfile ? tr("Draw another closed line: beside the first to split the wood, within it "
                                 "for a hollow.")
                            : tr("Draw a closed line, or begin with one of these shapes.");
    case ProfileCanvas::Mode::Attractor:
        return tr("Drag a straight line: the strands gather at it.");
    case ProfileCanvas::Mode::Points:
        return tr("Drag the points of a line.");
    case ProfileCanvas::Mode::Erase:
        return tr("Tap a line to take it away.");
    }
    return {};
}

void ProfilePanel::tell(const QString& sentence, bool isFault)
{
    m_faultText = isFault ? sentence : QString();
    QString shown = sentence;
    if (shown.isEmpty() && m_span != Span::None)
        shown = tr("Tap the other end on this branch, or go there with ▲ and ▼ and press the button again.");
    const bool isAdvice = shown.isEmpty();
    if (isAdvice && m_hasNode)
        shown = m_shapeName.isEmpty() ? advice() : m_shapeName;
    m_message->setText(shown);
    const QColor& colour = isFault ? theme::kWarning : isAdvice ? theme::kDimText : theme::kText;
    m_message->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
}

} // namespace espalier
