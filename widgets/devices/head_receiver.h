#pragma once

#include <QHostAddress>
#include <QObject>
#include <QUdpSocket>

#include <memory>

#include "engine/operator/head/opentrack_protocol.h"

namespace glissade {

/// Receives the data of a head tracker. There is no socket before open(). Used on the thread that it lives in.
class HeadReceiver final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// `fromAnywhere`: data of any machine are received, else only data of this one. Port 0 selects a free one. Returns
  /// false if the port cannot be opened; trouble() then gives the reason.
  bool open(int port, bool fromAnywhere);
  void close() { socket_.reset(); }
  bool isOpen() const { return socket_ != nullptr; }
  /// Port of the open socket; 0: no socket is open.
  int port() const { return socket_ ? socket_->localPort() : 0; }
  QHostAddress address() const { return socket_ ? socket_->localAddress() : QHostAddress(); }
  QString trouble() const { return trouble_; }
  /// Whether a datagram has come that was not read yet.
  bool hasMore() const { return socket_ && socket_->hasPendingDatagrams(); }
  /// Number of datagrams since open() that held no pose of a head.
  std::uint64_t dropped() const { return dropped_; }

 signals:
  /// The newest reading of the datagrams that have come.
  void received(const glissade::HeadReading& reading);

 private:
  void read();

  std::unique_ptr<QUdpSocket> socket_;
  QString trouble_;
  std::uint64_t dropped_ = 0;
};

}  // namespace glissade
