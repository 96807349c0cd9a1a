#pragma once

#include <QHostAddress>
#include <QObject>
#include <QUdpSocket>

#include <memory>

#include "engine/operator/head/opentrack_protocol.h"

namespace glissade {

/// Receives what a tracker sends of a head. Without open() there is no socket. On the thread that it lives in.
class HeadReceiver final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Only what this machine sends is received, or what any machine sends. Port 0: one that is free. False, and
  /// trouble() says why, where the port cannot be had.
  bool open(int port, bool fromAnywhere);
  void close() { socket_.reset(); }
  bool isOpen() const { return socket_ != nullptr; }
  /// Of the open socket; 0: there is none.
  int port() const { return socket_ ? socket_->localPort() : 0; }
  QHostAddress address() const { return socket_ ? socket_->localAddress() : QHostAddress(); }
  QString trouble() const { return trouble_; }
  /// Something has come that was not read yet.
  bool hasMore() const { return socket_ && socket_->hasPendingDatagrams(); }
  /// Datagrams that were no place of a head, since open().
  std::uint64_t dropped() const { return dropped_; }

 signals:
  /// The newest of those that have come.
  void received(const glissade::HeadReading& reading);

 private:
  void read();

  std::unique_ptr<QUdpSocket> socket_;
  QString trouble_;
  std::uint64_t dropped_ = 0;
};

}  // namespace glissade
