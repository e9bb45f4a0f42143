// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Icon.h"

#include "panels/Theme.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace espalier {

namespace {

QColor colourFor(QIcon::Mode mode, QIcon::State state)
{
    if (mode == QIcon::Disabled)
        return theme::kFaintText;
    if (state == QIcon::On)
        return mode == QIcon::Active ? theme::kBrightText : theme::kAccentText;
    return mode == QIcon::Active ? theme::kBrightText : theme::kText;
}

class StrokedIconEngine : public QIconEngine {
public:
    explicit StrokedIconEngine(QByteArray svg, QString name) : m_svg(std::move(svg)), m_name(std::move(name))
    {
    }

    QIconEngine* clone() const override { return new StrokedIconEngine(*this); }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        QByteArray svg = m_svg;
        svg.replace("currentColor", colourFor(mode, state).name().toLatin1());
        QSvgRenderer(svg).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return scaledPixmap(size, mode, state, 1.0);
    }

    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override
    {
        const QString key =
            QStringLiteral("espalier-icon-%1-%2-%3-%4").arg(m_name).arg(size.width()).arg(mode).arg(state);
        QPixmap pixmap;
        if (!QPixmapCache::find(key, &pixmap)) {
            pixmap = QPixmap(size);
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            paint(&painter, QRect(QPoint(), size), mode, state);
            painter.end();
            QPixmapCache::insert(key, pixmap);
        }
        return pixmap;
    }

private:
    QByteArray m_svg;
    QString m_name;
};

} // namespace

QIcon icon(const QString& name)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("There is no icon \"%s\".", qPrintable(name));
    return QIcon(new StrokedIconEngine(file.readAll(), name));
}

} // namespace espalier
