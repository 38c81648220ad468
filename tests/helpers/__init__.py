# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests share: programs and machines made for them, and judges that are independent of the product."""
