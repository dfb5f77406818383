            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const $number$ odd = matrices->cm1[row][column];
            const bool divides = (odd < $zero$) || (odd > $zero$);
            $number$ divided = $zero$;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
