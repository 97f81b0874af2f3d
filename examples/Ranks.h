// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_RANKS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_RANKS_H

#include <CGAL/IO/Gaussian_mixture_builder_3.h>

#include <boost/interprocess/streams/bufferstream.hpp>
#include <boost/interprocess/streams/vectorstream.hpp>
#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

/// Thrown in all ranks but those that failed, which have said why.
struct Another_rank_failed
{};

/// The processes of a run, which work on their shares and stop together if one cannot go on.
class Ranks
{
public:
  explicit Ranks(const boost::mpi::communicator& world) : world_(world) {}

  bool is_first() const { return world_.rank() == 0; }
  int rank() const { return world_.rank(); }
  int size() const { return world_.size(); }

  /// Whether all have ended their work because one failed, so that nobody waits for another.
  bool have_stopped() const { return have_stopped_; }

  /// What reports the share in [0, 1] of a rank's work that is done.
  using Report = std::function<void(double)>;

  /// Does `work(report)` in each rank, and shows the mean of their reports in the first one.
  /// \throws what `work` throws in this rank; Another_rank_failed in the others, at their next
  /// report
  template <typename Work>
  void together(const Work& work, const Report& show)
  {
    shares_.assign(static_cast<std::size_t>(size()), 0);
    reported_ = Clock::now();
    std::exception_ptr error;
    try {
      work([&](double share) {
        if(Clock::now() - reported_ > std::chrono::milliseconds(50)) {
          reported_ = Clock::now();
          if(is_first()) {
            listen(share, show);
            if(has_failed())
              throw Another_rank_failed();
          } else
            tell(share);
        }
      });
    } catch(...) {
      error = std::current_exception();
    }
    is_first() ? wait_for_all(error ? failed : done, show) : tell_the_end(error ? failed : done);
    const bool all_succeeded = boost::mpi::all_reduce(world_, !error, std::logical_and<bool>());
    have_stopped_ = !all_succeeded;
    if(error)
      std::rethrow_exception(error);
    if(!all_succeeded)
      throw Another_rank_failed();
  }

  /// Adds up the builders of all ranks in the first one, in a tree: in log2(ranks) steps, and in
  /// the memory of two builders and of the bytes of one. The others become empty.
  template <typename Builder>
  void reduce(Builder& builder) const
  {
    for(int step = 1; step < size(); step *= 2) {
      if(rank() % (2 * step) != 0) {
        send(rank() - step, builder);
        builder = Builder();
        return;
      }
      if(rank() + step < size())
        builder.merge(received<Builder>(rank() + step));
    }
  }

private:
  using Clock = std::chrono::steady_clock;
  enum Tag { share_tag, stop_tag, builder_tag };
  static constexpr double done = 2, failed = -1;
  static constexpr std::size_t most_bytes = std::size_t(1) << 30; ///< Of a message; an int counts.

  /// Rank 0: what the others report.
  void listen(double own_share, const Report& show)
  {
    shares_[0] = own_share;
    while(const auto message = world_.iprobe(boost::mpi::any_source, share_tag))
      world_.recv(message->source(), share_tag,
                  shares_[static_cast<std::size_t>(message->source())]);
    double sum = 0;
    for(double share : shares_)
      sum += std::clamp(share, 0., 1.);
    show(sum / size());
  }

  bool has_failed() const
  {
    return std::find(shares_.begin(), shares_.end(), failed) != shares_.end();
  }

  bool all_have_ended() const
  {
    return std::all_of(shares_.begin(), shares_.end(),
                       [](double share) { return share == done || share == failed; });
  }

  void wait_for_all(double own_share, const Report& show)
  {
    bool told = false;
    for(;; std::this_thread::sleep_for(std::chrono::milliseconds(2))) {
      listen(own_share, show);
      if(has_failed() && !std::exchange(told, true))
        tell_all();
      if(all_have_ended())
        break;
    }
    if(!told)
      tell_all();
  }

  /// That the work is over: each waits for it, or stops.
  void tell_all()
  {
    for(int other = 1; other < size(); ++other)
      world_.send(other, stop_tag);
  }

  /// Other ranks: the share, unless the one before is still on its way.
  void tell(double share)
  {
    if(world_.iprobe(0, stop_tag))
      throw Another_rank_failed();
    if(sent_ && !sent_->test())
      return;
    share_ = share;
    sent_ = world_.isend(0, share_tag, share_);
  }

  void tell_the_end(double share)
  {
    if(sent_)
      sent_->wait();
    sent_.reset();
    world_.send(0, share_tag, share);
    while(!world_.iprobe(0, stop_tag)) // waiting in recv() would take all the time of a core
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    world_.recv(0, stop_tag);
  }

  template <typename Builder>
  void send(int to, const Builder& builder) const
  {
    boost::interprocess::basic_ovectorstream<std::string> os; // unlike others it copies no bytes
    CGAL::IO::write_moments(os, builder);
    std::string bytes;
    os.swap_vector(bytes);
    world_.send(to, builder_tag, static_cast<std::uint64_t>(bytes.size()));
    for(std::size_t begin = 0; begin < bytes.size(); begin += most_bytes)
      world_.send(to, builder_tag, bytes.data() + begin,
                  static_cast<int>(std::min(most_bytes, bytes.size() - begin)));
  }

  template <typename Builder>
  Builder received(int from) const
  {
    std::uint64_t size = 0;
    world_.recv(from, builder_tag, size);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    for(std::size_t begin = 0; begin < bytes.size(); begin += most_bytes)
      world_.recv(from, builder_tag, &bytes[begin],
                  static_cast<int>(std::min(most_bytes, bytes.size() - begin)));
    boost::interprocess::ibufferstream is(bytes.data(), bytes.size());
    Builder builder;
    CGAL::IO::read_moments(is, builder);
    return builder;
  }

  boost::mpi::communicator world_;
  std::vector<double> shares_; ///< Of each rank, in rank 0.
  double share_ = 0;           ///< On its way to rank 0.
  std::optional<boost::mpi::request> sent_;
  bool have_stopped_ = false;
  Clock::time_point reported_;
};

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_RANKS_H
