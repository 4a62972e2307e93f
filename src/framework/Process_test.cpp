#include "framework/Process.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

struct NumberPackage {
  int number = 0;

  static constexpr auto fields() { return std::tuple{field("number", &NumberPackage::number)}; }
};

/// Example1 of report C.3.2.
class Example1 : public Process {
 public:
  explicit Example1(bool blocking = false) : Process{"Example1"}, numbers{*this, blocking} {}
  Sender<NumberPackage> numbers;

 protected:
  int main() override {
    ++numbers.number;
    numbers.send();
    return 100;
  }
};

/// Example2 of report C.3.3.
class Example2 : public Process {
 public:
  explicit Example2(bool blocking = true) : Process{"Example2"}, numbers{*this, blocking} {}
  Receiver<NumberPackage> numbers;
  std::vector<int> printed;

 protected:
  int main() override {
    printed.push_back(numbers.number);
    return 0;
  }
};

class Counter : public Process {
 public:
  explicit Counter(int wait) : Process{"Counter"}, wait_{wait} {}
  int count = 0;

 protected:
  int main() override {
    ++count;
    return wait_;
  }

 private:
  int wait_;
};

TEST(Process, ReturnValueIsPauseOrCycleTime) {
  for (const int wait : {500, -500}) {
    Counter counter{wait};
    for (int ms = 0; ms < 2000; ms += 100) counter.step({ms});
    EXPECT_EQ(counter.count, 4);
  }
}

TEST(Process, ZeroWithoutBlockingReceiverRunsOnce) {
  Counter counter{0};
  for (int ms = 0; ms < 1000; ms += 8) counter.step({ms});
  EXPECT_EQ(counter.count, 1);
}

TEST(Process, BlockingReceiverAlwaysPrintsANewNumber) {
  Example1 sender;
  Example2 receiver;
  sender.numbers.connect(receiver.numbers);
  for (int ms = 0; ms < 350; ms += 10) {
    sender.step({ms});
    receiver.step({ms});
  }
  EXPECT_EQ(receiver.printed, (std::vector<int>{1, 2, 3, 4}));
}

TEST(Process, NonBlockingReceiverMayHoldTheSamePackageForSeveralCycles) {
  Example1 sender;
  class Poller : public Example2 {
   public:
    Poller() : Example2{false} {}
    int fresh = 0;

   protected:
    int main() override {
      fresh += numbers.receivedNew();
      Example2::main();
      return 10;
    }
  } receiver;
  sender.numbers.connect(receiver.numbers);
  for (int ms = 0; ms < 50; ms += 10) {
    sender.step({ms});
    receiver.step({ms});
  }
  EXPECT_EQ(receiver.printed, (std::vector<int>{1, 1, 1, 1, 1}));
  EXPECT_EQ(receiver.fresh, 1);
}

TEST(Process, SlowReceiverGetsTheNewestPackage) {
  Example1 sender;
  Example2 receiver;
  sender.numbers.connect(receiver.numbers);
  for (int ms = 0; ms < 300; ms += 100) sender.step({ms});
  receiver.step({300});
  EXPECT_EQ(receiver.printed, (std::vector<int>{3}));
}

TEST(Process, RequestedNewNeedsOneReceiverBlockingSenderAll) {
  Example1 sender{true};
  Example2 fast, slow;
  sender.numbers.connect(fast.numbers);
  sender.numbers.connect(slow.numbers);
  EXPECT_TRUE(sender.step({0}));
  EXPECT_FALSE(sender.numbers.requestedNew());
  fast.step({0});
  EXPECT_TRUE(sender.numbers.requestedNew());
  EXPECT_FALSE(sender.step({100})) << "waits until all receivers requested";
  slow.step({100});
  EXPECT_TRUE(sender.step({100}));
}

}  // namespace
}  // namespace gt
